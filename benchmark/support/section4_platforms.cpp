#include "support/section4_platforms.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "cdpr_kinetostatics/robot/forward.h"
#include "robot_audit.h"
#include "robot_cases.h"
#include "suspended_platform.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kHomeLength = 4.5;  // [m]
constexpr double kTolerance = 1e-8;
constexpr double kTimeout = 2.0;  // [s]

enum class Lengths { kAlone, kTogether };

struct Case {
  RobotDescription robot;
  Lengths lengths = Lengths::kAlone;

  const char* name() const { return lengths == Lengths::kAlone ? "alone" : "together"; }
};

std::vector<double> lengthsAt(const Case& each, double first) {
  std::vector<double> lengths(each.robot.cables.size(), kHomeLength);
  lengths[0] = first;
  if (each.lengths == Lengths::kAlone) return lengths;
  const Eigen::Vector3d along =
      each.robot.home.transform(each.robot.cables[0].attachment) - each.robot.cables[0].anchor;
  const double across = along.tail<2>().squaredNorm();
  const Eigen::Vector3d moved((-std::sqrt(first * first - across)) - along.x(), 0.0, 0.0);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const CableDescription& cable = each.robot.cables[i];
    lengths[i] = (each.robot.home.transform(cable.attachment) + moved - cable.anchor).norm();
  }
  return lengths;
}

// One point by one model: solved a few times for the time's sake.
struct Point {
  RobotSolution solution;
  double time = 0.0;  // median [s]
};

Point solvePoint(const Case& each, double first, Model model, int repeats) {
  ForwardRequest request;
  request.lengths = lengthsAt(each, first);
  RobotSolverOptions options;
  options.model = model;
  options.tolerance = kTolerance;
  options.timeout = std::chrono::duration<double>(kTimeout);
  Point point;
  std::vector<double> times;
  for (int k = 0; k < repeats; ++k) {
    const double begin = now();
    point.solution = solveForward(each.robot, request, options);
    times.push_back(now() - begin);
    if (!point.solution.report.status.ok()) break;
  }
  point.time = quantile(times, 0.5);
  return point;
}

void write(const Case& each, double first, Model model, const Point& point, std::ostream* csv) {
  const RobotSolution& solution = point.solution;
  const Eigen::Vector3d& p = solution.pose.position;
  *csv << each.robot.cables.size() << ',' << each.name() << ',' << each.robot.weight() << ',' << first << ','
       << modelName(model) << ',' << static_cast<int>(solution.report.status.code) << ',';
  if (solution.report.status.ok()) {
    std::vector<double> tensions = tensionsOf(solution);
    const auto pushes = [](const CableResult& result) { return result.condition == Condition::kCompressed; };
    *csv << p.x() << ',' << p.y() << ',' << p.z() << ','
         << solution.pose.orientation.angularDistance(Eigen::Quaterniond::Identity()) << ','
         << *std::min_element(tensions.begin(), tensions.end()) << ','
         << *std::max_element(tensions.begin(), tensions.end()) << ','
         << std::count_if(solution.cables.begin(), solution.cables.end(), pushes);
  } else {
    *csv << ",,,,,,";
  }
  *csv << ',' << 1e6 * point.time << '\n';
}

// What one model did on one sweep.
struct Summary {
  int points = 0, solved = 0;
  std::vector<double> times;
  double apart = 0.0;    // largest distance of the platform from where BENDING has it [m]
  double closure = 0.0;  // largest distance of a cable's end from the platform, computed anew [m]
  double balance = 0.0;  // largest unbalanced force, summed anew, over the platform's weight; moment likewise

  void add(const RobotDescription& robot, const Point& point, const RobotSolution& bending) {
    ++points;
    if (!point.solution.report.status.ok()) return;
    ++solved;
    times.push_back(point.time);
    const RobotAudit found = audit(robot, Wrench::Zero(), point.solution);
    closure = std::max(closure, found.closure);
    balance = std::max({balance, found.force, found.moment});
    if (!bending.report.status.ok()) return;
    apart = std::max(apart, (point.solution.pose.position - bending.pose.position).norm());
  }
};

void sweep(const Case& each, bool quick, std::ostream* csv) {
  const std::vector<Model> models = {Model::kBending, Model::kBendingInextensible, Model::kCatenary, Model::kStraight};
  std::vector<Summary> summaries(models.size());
  const int points = quick ? 3 : 21;
  for (int i = 0; i < points; ++i) {
    const double first = 4.0 + i / (points - 1.0);
    RobotSolution bending;
    for (std::size_t m = 0; m < models.size(); ++m) {
      const Point point = solvePoint(each, first, models[m], quick ? 1 : 3);
      write(each, first, models[m], point, csv);
      if (m == 0) bending = point.solution;
      summaries[m].add(each.robot, point, bending);
    }
  }
  for (std::size_t m = 0; m < models.size(); ++m) {
    const Summary& summary = summaries[m];
    std::printf("%zu cables  %-8s %6.0f N  %-21s %3d of %3d %9.0f us %12.3f mm", each.robot.cables.size(), each.name(),
                each.robot.weight(), modelName(models[m]), summary.solved, summary.points,
                1e6 * quantile(summary.times, 0.5), 1e3 * summary.apart);
    if (!isStraight(models[m])) std::printf(" %9.0e m %9.0e", summary.closure, summary.balance);
    std::printf("\n");
  }
}

}  // namespace

void sweepPlatforms(const RobotDescription& like, bool quick, std::ostream* csv) {
  *csv << "cables,sweep,load_N,length_1_m,model,code,x_m,y_m,z_m,rotation_rad,tension_min_N,tension_max_N,compressed,"
          "time_us\n";
  std::printf("\n%-8s  %-8s %8s  %-21s %10s %12s %15s %11s %9s\n", "robot", "sweep", "load", "model", "solved", "time",
              "from bending", "closure", "balance");
  for (const int corners : {3, 4}) {
    for (const Lengths lengths : {Lengths::kAlone, Lengths::kTogether}) {
      for (const double load : {250.0, 5000.0}) {
        sweep({suspendedPlatform(like, corners, 2 * corners * load), lengths}, quick, csv);
      }
    }
  }
}

}  // namespace cdpr_kinetostatics
