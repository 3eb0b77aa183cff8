#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

std::vector<double> lengthsOf(const RobotSolution& solution) {
  std::vector<double> lengths;
  for (const CableResult& result : solution.cables) lengths.push_back(result.cable.length);
  return lengths;
}

std::vector<double> tensionsOf(const RobotSolution& solution) {
  std::vector<double> tensions;
  for (const CableResult& result : solution.cables) tensions.push_back(result.cable.tension_a);
  return tensions;
}

}  // namespace cdpr_kinetostatics
