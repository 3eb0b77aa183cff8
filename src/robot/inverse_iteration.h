// One iteration of inverse kinetostatics after another: linearise the cables, distribute the tensions, step. A
// workspace with the state that the iterations work on (docs/theory.md section 5, equation (36)).
#pragma once

#include <vector>

#include "cable/rung_problems.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/inverse_cable.h"
#include "robot/robot_forces.h"
#include "robot/search_outcome.h"
#include "robot/tension_program.h"

namespace cdpr_kinetostatics {

class InverseIteration {
 public:
  struct Move {
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();  // of a free attitude [rad]
    double size = 0.0;                               // relative, as CoupledNewton::size()
    double damping = 1.0;                            // keeps every cable within reach of its linearisation
    bool finite = true;
  };

  // The robot must outlive the object.
  explicit InverseIteration(const RobotDescription& robot) : robot_(robot) {}

  // Sets the problem; the cables stay as they are.
  void begin(const InverseRequest& request);
  // Puts every cable at its preferred tension, moved into its limits, on a closed-form model.
  Status startCables(const RungOptions& closed_form, double tolerance);
  // The same forces and lengths on other models.
  void useRungs(const std::vector<Model>& rungs, double tolerance);

  // False: a cable cannot be evaluated, or has no stiffness, here.
  bool linearise(Steps steps);
  // Of the linearised cables: the nearest tensions to the preferred ones within the limits in use.
  void distribute();
  // Both, with cables that have stepped over their folds brought back, and limits that the folds allow.
  bool linearisedAboveFolds(const RungOptions& closed_form, Steps steps);

  // The step to the tensions distributed last.
  Move plannedMove() const;
  void take(const Move& move);
  // The turn has no curvature in the linearised problem: where it swings, its weight must grow.
  void makeTurnHeavier();

  bool isFree() const { return turn_.free; }
  // The limits can be met.
  bool isFeasible() const { return distribution_.feasible; }
  // No imbalance is left that no tensions can remove.
  bool isBalanced() const;
  // INFEASIBLE, if one of these two is not so: which limits contradict each other, or what is left.
  Status infeasible() const;

  Residuals residuals() const;
  RobotForces reached() const;
  const Pose& pose() const { return pose_; }
  std::vector<InverseCable>& cables() { return cables_; }
  const std::vector<InverseCable>& cables() const { return cables_; }
  const TensionDistribution& distribution() const { return distribution_; }

 private:
  Status unbalanced() const;

  const RobotDescription& robot_;
  Wrench external_ = Wrench::Zero();
  Pose pose_;
  FreeTurn turn_;
  Eigen::VectorXd preferred_;  // [N]
  std::vector<InverseCable> cables_;
  TensionDistribution distribution_;
};

}  // namespace cdpr_kinetostatics
