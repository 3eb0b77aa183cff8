// AUTO on a robot: for each cable the coarsest model ("rung" of the ladder of models) with which the platform stays
// within the accuracy asked for.
//
// What each rung leaves out is estimated cable by cable (cable/rung_error.h) and taken to the platform by the robot's
// stiffness; rungs are then refined, the worst cable's first, until the sum is small enough (docs/theory.md section 5,
// equation (37)).
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "cable/rung_error.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/robot_forces.h"

namespace cdpr_kinetostatics {

// Where the error of each rung that AUTO chooses from takes the platform, for one cable: translation [m], and rotation
// times the platform's radius [m]. A rung that is not known is not chosen; BENDING is.
struct RungEffects {
  std::array<Wrench, kAutoRungCount> displacement;
  std::array<bool, kAutoRungCount> known;
};

// A workspace: choosing again allocates nothing.
class RungChoice {
 public:
  // The coarsest rungs with which the platform's error stays within accuracy [m]. kept, if not empty, are the rungs in
  // use: none is given up for a coarser one that would only just do, so that a stream of poses does not flicker.
  const std::vector<Model>& choose(const std::vector<RungEffects>& cables, double accuracy,
                                   const std::vector<Model>& kept);

  // For a robot at a pose near the solution. state holds the catenaries' forces; where the robot has no stiffness,
  // every cable bends.
  const std::vector<Model>& choose(const RobotDescription& robot, const RobotForces& state, double accuracy,
                                   const std::vector<Model>& kept);

  // Whether the rungs in use serve at a state along a path: no cable needs a finer one, and it has not been so for many
  // states that some cable could do with a coarser one.
  bool serve(const RobotDescription& robot, const RobotForces& state, double accuracy, const std::vector<Model>& used);

 private:
  bool estimate(const RobotDescription& robot, const RobotForces& state);

  std::vector<RungErrors> errors_;
  std::vector<RungEffects> effects_;
  std::vector<std::size_t> needed_, ample_;  // into kAutoRungs
  std::vector<Model> rungs_;
  int needlessly_fine_ = 0;  // states served in a row
};

// Makes each cable's rung one finer where there is a finer one. False if there was none.
bool refineRungs(std::vector<Model>* rungs);

}  // namespace cdpr_kinetostatics
