// Would the platform stay where it is? Judged by its stiffness at fixed lengths (docs/theory.md section 5).
#pragma once

#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/report.h"
#include "robot/linear_robot.h"

namespace cdpr_kinetostatics {

enum class Stability { kStable, kNeutral, kUnstable };

struct PlatformStability {
  Stability kind = Stability::kStable;
  // Motions that nothing resists, or the one that the platform takes most readily where it is unstable: translation [m]
  // and rotation vector [rad], world axes, of unit size when rotations count with the lever. None if stable.
  std::vector<Wrench> motions;
};

// stiffness: d(total wrench)/d(translation, rotation vector). A freedom that nothing resists is neutral.
PlatformStability platformStability(const RobotDescription& robot, const LinearRobot::Stiffness& stiffness);

// CONVERGED without a word; CONVERGED with the sentence that names the open motions; or UNSTABLE, and where the
// platform would go.
Status describeStability(const RobotDescription& robot, const PlatformStability& stability);

}  // namespace cdpr_kinetostatics
