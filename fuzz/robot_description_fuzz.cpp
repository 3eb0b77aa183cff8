// Robot files: any text either loads as a robot that the solvers can be asked about, or is refused with a sentence.
#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <string>

#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cdpr_kinetostatics;
  RobotDescription robot;
  try {
    robot = parseRobot(YAML::Load(std::string(reinterpret_cast<const char*>(data), size))).robot;
  } catch (const std::invalid_argument& refused) {
    require(std::string(refused.what()).size() > 10, "a refusal without a sentence", {});
    return 0;
  } catch (const YAML::Exception&) {  // no YAML at all: the node and loadRobotFile() say where
    return 0;
  }
  InverseRequest request;
  request.pose = robot.home;
  RobotSolverOptions options;
  options.model = Model::kCatenary;
  options.timeout = std::chrono::duration<double>(0.02);
  requireHonest(robot, request.external_wrench, solveInverse(robot, request, options));
  return 0;
}
