// Forward kinetostatics of random robots.
#include "cdpr_kinetostatics/robot/forward.h"
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
  options.compute_stiffness = input.flag();
  ForwardRequest request;
  request.external_wrench = fuzzedWrench(&input);
  if (input.flag()) request.seed = fuzzedPose(&input, 3.0);
  const Pose at = request.seed.value_or(robot.home);
  const double slack = input.number(0.98, 1.2);
  for (const CableDescription& cable : robot.cables) {
    const double chord = (at.transform(cable.attachment) - cable.anchor).norm();
    request.lengths.push_back(input.flag() ? chord * slack : input.magnitude(1e-2, 1e2));
  }
  requireHonest(robot, request.external_wrench, solveForward(robot, request, options));
  return 0;
}
