#include "support/section4_two_cables.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "cdpr_kinetostatics/robot/forward.h"
#include "robot_cases.h"
#include "support/two_cable_sweep.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kTolerance = 1e-11;        // of the table
constexpr double kDefaultTolerance = 1e-8;  // what a solve costs that nobody asked more of
constexpr double kSecondLength = 7.0;       // [m]
constexpr double kSweepGap = 1e-10;         // [m]
constexpr double kFirstShare = 0.2;  // of the catenary's forces, from which the first sweep of a trajectory starts
constexpr double kNextShare = 0.05;  // of the forces of the point before
constexpr int kPoints = 101;         // on a trajectory
constexpr int kSweepEvery = 10;

// One load and model along the trajectory.
class Trajectory {
 public:
  Trajectory(const RobotDescription& robot, Model model, bool quick, std::ostream* csv)
      : robot_(robot), model_(model), step_(quick ? kPoints / 2 : 1), repeats_(quick ? 3 : 11), csv_(*csv) {}

  void run() {
    for (int i = 0; i < kPoints; i += step_) {
      const Eigen::Vector2d lengths(4.0 + i / (kPoints - 1.0), kSecondLength);
      const RobotSolution precise = coupled(lengths, kTolerance, "coupled", &coupled_times_);
      const RobotSolution usual = coupled(lengths, kDefaultTolerance, "default", &default_times_);
      default_error_ = std::max(default_error_, (usual.pose.position - precise.pose.position).norm());
      last_ = precise;
      if (isBending(model_) && i % kSweepEvery == 0) swept(lengths);
    }
    std::printf("%7.0f N  %-21s %7.1f us %9.1f us %10.1e m", robot_.weight(), modelName(model_),
                1e6 * quantile(coupled_times_, 0.5), 1e6 * quantile(default_times_, 0.5), default_error_);
    if (!sweep_times_.empty()) {
      const double ratio = quantile(sweep_times_, 0.5) / quantile(coupled_times_, 0.5);
      std::printf(" %9.1f ms %7.0f %7.0f %9.1e m", 1e3 * quantile(sweep_times_, 0.5), quantile(sweep_solves_, 0.5),
                  ratio, apart_);
    }
    std::printf("\n");
  }

 private:
  RobotSolution solve(const Eigen::Vector2d& lengths, Model model, double tolerance) const {
    ForwardRequest request;
    request.lengths = {lengths.x(), lengths.y()};
    request.seed = robot_.home;
    if (last_.report.status.ok()) request.seed->position = last_.pose.position;
    RobotSolution solution = solveForward(robot_, request, patient(model, tolerance));
    if (!solution.report.status.ok()) throw std::runtime_error(solution.report.status.message);
    return solution;
  }

  // From the position before, several times for the time's sake.
  RobotSolution coupled(const Eigen::Vector2d& lengths, double tolerance, const char* method,
                        std::vector<double>* medians) {
    std::vector<double> times;
    RobotSolution solution;
    for (int k = 0; k < repeats_; ++k) {
      const double begin = now();
      solution = solve(lengths, model_, tolerance);
      times.push_back(now() - begin);
    }
    medians->push_back(quantile(times, 0.5));
    const CableSolution& first = solution.cables[0].cable;
    write(lengths, method, {solution.pose.position.x(), solution.pose.position.z()},
          {first.horizontal_force, first.vertical_force_a}, solution.cables[1].cable.tension_a, 0, medians->back());
    return solution;
  }

  void swept(const Eigen::Vector2d& lengths) {
    Eigen::Vector2d around = swept_forces_;
    double share = kNextShare;
    if (sweep_times_.empty()) {
      const CableSolution catenary = solve(lengths, startingRung(model_), kTolerance).cables[0].cable;
      around << catenary.horizontal_force, catenary.vertical_force_a;
      share = kFirstShare;
    }
    CableSolverOptions options;
    options.model = model_;
    options.tolerance = kTolerance;
    const double begin = now();
    const SweptPoint point = sweepForces(robot_, lengths, around, share, kSweepGap, options);
    sweep_times_.push_back(now() - begin);
    sweep_solves_.push_back(point.cable_solves);
    swept_forces_ = point.forces;
    const Eigen::Vector2d direct(last_.pose.position.x(), last_.pose.position.z());
    apart_ = std::max(apart_, (point.position - direct).norm());
    write(lengths, "swept", point.position, point.forces, point.tension_2, point.cable_solves, sweep_times_.back());
  }

  void write(const Eigen::Vector2d& lengths, const char* method, const Eigen::Vector2d& position,
             const Eigen::Vector2d& forces, double tension_2, int cable_solves, double time) {
    csv_ << robot_.weight() << ',' << lengths.x() << ',' << modelName(model_) << ',' << method << ',' << position.x()
         << ',' << position.y() << ',' << forces.x() << ',' << forces.y() << ',' << forces.norm() << ',' << tension_2
         << ',' << cable_solves << ',' << 1e6 * time << '\n';
  }

  const RobotDescription robot_;
  const Model model_;
  const int step_, repeats_;
  std::ostream& csv_;
  RobotSolution last_;
  Eigen::Vector2d swept_forces_ = Eigen::Vector2d::Zero();
  std::vector<double> coupled_times_, default_times_, sweep_times_, sweep_solves_;
  double default_error_ = 0.0;  // largest distance of the default tolerance's position from the precise one [m]
  double apart_ = 0.0;          // largest distance between the results of both methods [m]
};

}  // namespace

void sweepTwoCables(const RobotDescription& robot, bool quick, std::ostream* csv) {
  *csv << "load_N,length_1_m,model,method,x_m,y_m,H_N,V_1_N,tension_1_N,tension_2_N,cable_solves,time_us\n";
  std::printf("%9s  %-21s %10s %12s %12s %12s %7s %7s %11s\n", "load", "model", "coupled", "default", "its error",
              "swept", "solves", "ratio", "apart");
  for (const double load : {500.0, 10000.0}) {
    RobotDescription loaded = robot;
    loaded.mass = load / robot.gravity;
    for (const Model model : {Model::kStraight, Model::kCatenary, Model::kBendingInextensible, Model::kBending}) {
      Trajectory(loaded, model, quick, csv).run();
    }
  }
}

}  // namespace cdpr_kinetostatics
