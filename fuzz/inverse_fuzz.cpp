// Inverse kinetostatics of random robots.
#include "cdpr_kinetostatics/robot/inverse.h"
#include "fuzzed_robot.h"
#include "invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cdpr_kinetostatics;
  FuzzedInput input(data, size);
  const RobotDescription robot = fuzzedRobot(&input);
  RobotSolverOptions options;
  options.model = input.model();
  options.accuracy = input.magnitude(1e-6, 1e-1);
  options.timeout = std::chrono::duration<double>(0.05);
  InverseRequest request;
  request.external_wrench = fuzzedWrench(&input);
  request.pose = fuzzedPose(&input, 3.0);
  request.free_orientation = input.flag();
  if (input.flag()) {
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      request.preferred_tensions.push_back(input.magnitude(1e-1, 1e4));
    }
  }
  requireHonest(robot, request.external_wrench, solveInverse(robot, request, options));
  return 0;
}
