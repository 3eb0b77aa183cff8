// One iteration of inverse kinetostatics after another: linearise the cables, distribute the pulls, step. A workspace
// with the state that the iterations work on (docs/theory.md section 5, equation (36)).
#pragma once

#include <vector>

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
    FreeAttitude::Turn turn;  // of a free attitude
    double size = 0.0;        // relative, as CoupledNewton::size()
    double damping = 1.0;     // keeps every cable within reach of its linearisation
    bool finite = true;
  };

  // The robot must outlive the object.
  explicit InverseIteration(const RobotDescription& robot) : problem_{robot, Wrench::Zero(), {}, {}} {}

  // Sets the problem; the cables stay as they are.
  void begin(const InverseRequest& request);
  // Starts from another attitude than the request's.
  void setAttitude(const Eigen::Quaterniond& attitude);
  // Puts every cable taut at its preferred tension, moved into its limits, on a closed-form model.
  Status startCables(Model closed_form, double tolerance);
  // The same forces and lengths, or of slack cables the same lengths, on other models.
  void useRungs(const std::vector<Model>& rungs, const SolveLimits& limits);

  // Closes every cable at its pull. False: one cannot be evaluated, or has no stiffness, here.
  bool closeCables(Steps steps);
  // Of the closed cables: the pulls whose tensions are nearest to the preferred ones. False as closeCables().
  bool distribute(SolveLimits::Clock::time_point deadline);
  // The step to the pulls distributed last.
  Move plannedMove() const;
  // Takes as much of it as brings objective and balance forward, and closes the cables there. False as closeCables().
  bool advance(const Move& move, Steps steps);

  // The same along a path, from a state near the answer, without second derivatives of taut cables and without a
  // search along the step. Both allocate nothing that they have allocated before.
  bool lineariseNearby(Steps steps) { return linearise(steps, kTautOnPath); }
  void distributeNearby() { distributePulls(SolveLimits::Clock::time_point::max()); }
  void take(const Move& move);

  const FreeAttitude& attitude() const { return problem_.attitude; }
  // The limits can be met.
  bool isFeasible() const;
  // No imbalance is left that no tensions can remove.
  bool isBalanced() const;
  // INFEASIBLE, if one of these two is not so: which limits contradict each other, or what is left.
  Status infeasible() const;

  Residuals residuals() const;
  RobotForces reached() const;
  const Pose& pose() const { return pose_; }
  std::vector<InverseCable>& cables() { return cables_; }
  const std::vector<InverseCable>& cables() const { return cables_; }

 private:
  // taut: as for InverseCable::linearise().
  bool linearise(Steps steps, double taut);
  // Where the attitude is given.
  void distributePulls(SolveLimits::Clock::time_point deadline);
  Eigen::VectorXd pulls() const;
  double merit() const;
  bool closeAt(const Eigen::VectorXd& pulls, const Eigen::Vector3d& turn, Steps steps);
  // No cable that hung as it should before a step hangs otherwise after it.
  bool keepsBranches() const;
  Status unbalanced() const;

  InverseProblem problem_;
  Pose pose_;
  std::vector<InverseCable> cables_;
  std::vector<InverseCable> before_;  // a step that is searched along
  TensionDistribution distribution_;  // tensions: pulls, and a turn behind them
  double price_ = 0.0;                // in the merit, of a newton of imbalance
  double price_of_limits_ = 0.0;      // and of a newton of pull beyond its limits
};

}  // namespace cdpr_kinetostatics
