// The linearised problem of inverse kinetostatics: which pulls of the cables, and which turn of a free attitude,
// balance the platform and bring the tensions nearest to the preferred ones (docs/theory.md section 5, equation (36)).
//
// Moments are divided by the robot's lever throughout; the cables are linearised at the pose.
#pragma once

#include <optional>
#include <vector>

#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/free_attitude.h"
#include "robot/inverse_cable.h"
#include "robot/quadratic_program.h"

namespace cdpr_kinetostatics {

struct InverseProblem {
  const RobotDescription& robot;
  Wrench external = Wrench::Zero();
  Eigen::VectorXd preferred;  // T_A of each cable [N]
  FreeAttitude attitude;
  double lever = robot.lever();  // moments are divided by it [m]

  // 1/(max - min) of cable i, what the objective divides its tension by [1/N].
  double weight(std::size_t i) const { return 1.0 / (robot.cables[i].tension_max - robot.cables[i].tension_min); }
};

// Half of the sum of squares in (36).
double objective(const InverseProblem& problem, const std::vector<InverseCable>& cables);

// The wrench that is left once the cables are closed, in the robot's freedoms.
Eigen::VectorXd imbalance(const InverseProblem& problem, const Pose& pose, const std::vector<InverseCable>& cables);

// In the pulls, for a given attitude. multipliers: of equilibrium, from the program before; they weigh the curvature of
// the forces. Empty: it is left out.
TensionProblem tensionProgram(const InverseProblem& problem, const Pose& pose, const std::vector<InverseCable>& cables,
                              const Eigen::VectorXd& multipliers);

// In changes of the pulls and of the attitude. Inequality i keeps the lower, n + i the upper limit of cable i, those
// that follow keep the turn small. Nothing where a cable cannot be evaluated.
std::optional<QuadraticProgram> attitudeProgram(const InverseProblem& problem, const Pose& pose,
                                                const std::vector<InverseCable>& cables,
                                                const Eigen::VectorXd& multipliers);

}  // namespace cdpr_kinetostatics
