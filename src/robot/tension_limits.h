// Limits of the tensions at a pose: those of the description, and folds, the least tensions that can hold the cables
// (docs/theory.md section 1, "How many answers").
//
// Below its fold a cable has no length, and at the fold no derivative: lower limits are raised to just above the folds,
// and a cable that has stepped over one starts anew on the taut side. Folds are those of closed-form models, whose
// problem 3 is cheap; RungOptions say which.
#pragma once

#include <vector>

#include "cable/rung_problems.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/inverse_cable.h"

namespace cdpr_kinetostatics {

// A cable's problem 3 at this tension [N], or, where that is below the fold, just above the fold, to which the cable's
// lower limit is then raised.
CableSolution lengthAboveFold(const CableProperties& properties, double tension, const RungOptions& closed_form,
                              InverseCable* cable);

// True if a cable under this tension [N] may be near its fold. A straight cable has none.
bool isNearFold(const InverseCable& cable, double tension, const RungOptions& closed_form);

// True if a cable hangs in a loop so deep that more tension means more length.
bool isBeyondFold(const InverseCable& cable, const RungOptions& closed_form);

// True if any cable would be at or near its fold under these tensions [N].
bool anyAtFold(const std::vector<InverseCable>& cables, const Eigen::VectorXd& tensions,
               const RungOptions& closed_form);

// Raises the lower limits of cables whose tension would be below their folds. True if there was one.
bool raiseLimitsToFolds(const RobotDescription& robot, const Eigen::VectorXd& tensions, const RungOptions& closed_form,
                        std::vector<InverseCable>* cables);

// Starts cables beyond their folds anew on the taut side. True if there was one.
bool pullBackFromFolds(const RobotDescription& robot, const RungOptions& closed_form,
                       std::vector<InverseCable>* cables);

// INFEASIBLE, with the names of the cables and limits that contradict each other.
Status contradiction(const RobotDescription& robot, const std::vector<InverseCable>& cables,
                     const TensionDistribution& distribution);

}  // namespace cdpr_kinetostatics
