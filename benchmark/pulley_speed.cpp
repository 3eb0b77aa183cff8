// What guide pulleys and dead lengths cost: warm forward and inverse solves of CoGiRo with them over those without,
// same path, same model (docs/performance.md).
//
//     pulley_speed [--quick] [--csv FILE]
//
// Every step times both robots once, so that both see the same disturbances; medians are compared.
#include <stdexcept>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/forward_follower.h"
#include "cdpr_kinetostatics/robot/inverse_follower.h"
#include "pulley_robots.h"
#include "support/benchmark_report.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kRadius = 0.06;      // [m]
constexpr double kDeadLength = 10.0;  // [m]
constexpr double kTarget = 1.3;

struct Times {
  std::vector<double> forward, inverse;  // [s]
};

// A robot with the state of its followers.
class Contender {
 public:
  Contender(const RobotDescription& robot, Model model)
      : robot_(robot), options_(patient(model)), forward_(robot_, options_), inverse_(robot_, options_) {}
  Contender(const Contender&) = delete;
  Contender& operator=(const Contender&) = delete;

  void step(const Pose& pose, bool timed) {
    ForwardRequest request;
    request.lengths = lengthsOf(solveInverse(robot_, requestFor(robot_, pose), options_));
    const InverseRequest to_pose = requestFor(robot_, pose);
    double begin = now();
    require(forward_.solve(request));
    if (timed) times.forward.push_back(now() - begin);
    begin = now();
    require(inverse_.solve(to_pose));
    if (timed) times.inverse.push_back(now() - begin);
  }

  const RobotDescription& robot() const { return robot_; }

  Times times;

 private:
  static void require(const Status& status) {
    if (!status.ok()) throw std::runtime_error(status.message);
  }

  const RobotDescription robot_;
  const RobotSolverOptions options_;
  ForwardFollower forward_;
  InverseFollower inverse_;
};

void measure(Model model, int steps, BenchmarkReport* report) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  Contender plain(robot, model);
  Contender pulleys(withPulleys(robot, kRadius, kDeadLength), model);
  for (int i = 0; i <= steps; ++i) {
    Pose pose = robot.home;
    pose.position.x() += 0.01 * (i % 80 < 40 ? i % 80 : 80 - i % 80);
    plain.step(pose, i > 0);
    pulleys.step(pose, i > 0);
  }
  // Where the platform would be by its lengths if the pulleys and dead lengths were left out of its description.
  ForwardRequest ignorant;
  ignorant.lengths = lengthsOf(solveInverse(pulleys.robot(), requestFor(robot, robot.home), patient(model)));
  const RobotSolution elsewhere = solveForward(robot, ignorant, patient(model));
  report->figure(1, std::string(modelName(model)) + ", pulleys left out: the platform is off by",
                 1e3 * (elsewhere.pose.position - robot.home.position).norm(), "mm");
  const auto add = [&](const std::string& what, const std::vector<double>& with, const std::vector<double>& without) {
    const std::string name = std::string(modelName(model)) + " " + what;
    report->atMost(1, name + ", with pulleys / without", quantile(with, 0.5) / quantile(without, 0.5), kTarget);
    report->figure(1, name + ", with pulleys", 1e6 * quantile(with, 0.5), "us");
  };
  add("forward", pulleys.times.forward, plain.times.forward);
  add("inverse", pulleys.times.inverse, plain.times.inverse);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  BenchmarkReport report(argc, argv);
  for (const Model model : {Model::kCatenary, Model::kCatenaryCorrected, Model::kBending}) {
    measure(model, report.quick() ? 80 : 800, &report);
  }
  return report.finish();
}
