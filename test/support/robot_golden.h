// The reference robots of test/golden/robots.json.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

struct GoldenRobot {
  struct Answer {
    std::vector<double> h, v, length, tension;
  };
  RobotDescription robot;  // limits are wide open
  Pose pose;
  Wrench external_wrench = Wrench::Zero();
  Answer catenary, bending;

  const Answer& answer(Model model) const { return isBending(model) ? bending : catenary; }
};

std::ostream& operator<<(std::ostream& out, const GoldenRobot& golden);

// Reads robots.json in the directory; throws if it is missing or malformed.
std::vector<GoldenRobot> goldenRobots(const std::string& directory);

}  // namespace cdpr_kinetostatics
