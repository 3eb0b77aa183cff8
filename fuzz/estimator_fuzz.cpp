// The estimator, fed with sequences of messages: exact ones at a random pose, noisy ones, and anything.
#include <vector>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "fuzzed_robot.h"
#include "invariants.h"

namespace cdpr_kinetostatics {
namespace {

std::optional<double> reading(FuzzedInput* input, double exact, double stddev) {
  switch (input->count(0, 9)) {
    case 0: return std::nullopt;
    case 1: return input->number(-1e3, 1e3);
    case 2: return exact + input->number(-1.0, 1.0);
    default: return exact + stddev * input->number(-3.0, 3.0);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cdpr_kinetostatics;
  FuzzedInput input(data, size);
  const RobotDescription robot = fuzzedRobot(&input);
  InverseRequest request;
  request.pose = robot.home;
  request.free_orientation = robot.cables.size() < 6;
  RobotSolverOptions solver;
  solver.model = Model::kCatenary;
  const RobotSolution truth = solveInverse(robot, request, solver);

  EstimatorOptions options;
  options.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
  options.model = input.model();
  options.timeout = std::chrono::duration<double>(0.05);
  options.known_load = input.flag();
  std::string error;
  if (!options.isValid(&error)) return 0;
  PoseEstimator estimator(robot, options);
  for (int message = input.count(1, 6); message > 0; --message) {
    CableMeasurements measurements;
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      const double length = truth.cables.empty() ? 4.0 : truth.cables[i].cable.length;
      const double tension = truth.cables.empty() ? 50.0 : truth.cables[i].cable.tension_a;
      measurements.lengths.push_back(reading(&input, length, options.length_stddev));
      measurements.tensions.push_back(reading(&input, tension, options.tension_stddev));
    }
    if (input.count(0, 9) == 0) estimator.setPose(fuzzedPose(&input, 3.0));
    requireHonest(robot, estimator.update(measurements));
  }
  return 0;
}
