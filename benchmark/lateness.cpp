// How late answers are that time ends: processor time beyond the timeout asked for, of hostile requests and messages on
// every shipped robot (docs/reliability.md).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "hostile_messages.h"
#include "hostile_requests.h"
#include "processor_time.h"
#include "ros/cable_service.h"
#include "ros/forward_service.h"
#include "ros/inverse_service.h"
#include "support/benchmark_report.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kAllowed = 5e-3;   // [s]
constexpr double kShortest = 1e-3;  // timeouts asked for [s]
constexpr double kLongest = 0.1;

class Lateness {
 public:
  template <typename Answer>
  void add(double timeout, const Answer& answer) {
    const double begin = processorTime();
    answer();
    late_.push_back(std::max(0.0, processorTime() - begin - timeout));
  }

  void report(const std::string& what, BenchmarkReport* report) const {
    std::printf("%-12s %8zu answers: 99.9 %% below %6.2f ms late, the latest %6.2f ms\n", what.c_str(), late_.size(),
                1e3 * quantile(late_, 0.999), 1e3 * quantile(late_, 1.0));
    report->atMost(9, what + ": latest answer after its timeout, over 5 ms", quantile(late_, 1.0) / kAllowed, 1.0);
  }

 private:
  std::vector<double> late_;  // [s]
};

void run(BenchmarkReport* report) {
  Lateness forward, inverse, cable, estimate;
  const int count = report->quick() ? 50 : 3000;
  for (const Workspace& workspace : shippedWorkspaces()) {
    NodeParameters parameters;
    parameters.robot = shippedRobot(ROBOT_DIR, workspace.robot);
    Dice dice(1);
    SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, workspace.robot);
    for (int i = 0; i < count; ++i) {
      const double timeout = kShortest * std::pow(kLongest / kShortest, dice.uniform(0.0, 1.0));
      HostileRequests requests(parameters.robot, timeout, true, static_cast<unsigned>(i));
      forward.add(timeout, [&] { keep(serveForward(parameters, requests.forward())); });
      inverse.add(timeout, [&] { keep(serveInverse(parameters, requests.inverse())); });
      cable.add(timeout, [&] { keep(serveCable(parameters, requests.cable())); });

      EstimatorOptions options = simulated.estimator;
      options.model = Model::kAuto;
      options.timeout = std::chrono::duration<double>(timeout);
      PoseEstimator estimator(simulated.robot, options);
      const CableMeasurements message = hostileMessage(simulated.measure(simulated.truth, 1.0), &dice);
      estimate.add(timeout, [&] { keep(estimator.update(message)); });
    }
  }
  forward.report("forward", report);
  inverse.report("inverse", report);
  cable.report("one cable", report);
  estimate.report("estimate", report);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  BenchmarkReport report(argc, argv);
  run(&report);
  return report.finish();
}
