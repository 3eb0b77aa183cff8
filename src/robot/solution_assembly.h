// From converged cables and a pose to a RobotSolution with its residuals, summed anew.
#pragma once

#include <string>
#include <vector>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"
#include "robot/search_outcome.h"

namespace cdpr_kinetostatics {

// No solution: the report says why.
RobotSolution refusedRobot(Model model, const Status& status);
// The same of a search that found none, with what it had reached.
RobotSolution failedRobot(Model model, const SearchOutcome& outcome);

// How the search behind a report ended.
SearchOutcome outcomeOf(const RobotReport& report);

// Cable i between its anchor and the platform at the pose, with so many profile points.
std::vector<CableSolution> describeCables(const RobotDescription& robot, const Pose& pose,
                                          const std::vector<SaggingCable>& cables, int profile_points);

// cables[i].cable describes cable i at the pose; fills names, conditions, world forces and profiles, and
// the report's residuals.
void assemble(const RobotDescription& robot, const Wrench& external, const std::vector<CableSolution>& cables,
              RobotSolution* solution);

}  // namespace cdpr_kinetostatics
