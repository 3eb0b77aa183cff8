// Newton's method on the whole robot at once: platform pose, forces of every cable, and the nodes inside
// every bending cable converge together (docs/theory.md section 5, equations (34) and (35)).
//
// Each iteration linearises every cable, eliminates its (H, V), and solves for the pose with the robot's
// 6x6 stiffness (3x3 for a point mass). Quadratic near a solution, local: the start comes from elsewhere.
#pragma once

#include <chrono>
#include <vector>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/chord_law.h"
#include "robot/linear_robot.h"
#include "robot/platform_stability.h"
#include "robot/platform_statics.h"
#include "robot/robot_forces.h"
#include "robot/search_outcome.h"

namespace cdpr_kinetostatics {

// The unknowns of a forward problem: pose, and the cables' forces and shapes at their lengths.
struct CoupledState {
  Pose pose;
  std::vector<SaggingCable> cables;  // in the robot's order; their models may differ
};

// Pose, lengths and forces alone; allocates nothing if forces has held as many cables before.
void readForces(const CoupledState& state, RobotForces* forces);

// Whether bending cables choose their integration steps anew: never, all, or those whose steps no longer serve.
enum class Steps { kKept, kNew, kNewWhereDue };

// One linearisation after another; a workspace that allocates nothing after its first use. The robot and the state
// that was linearised last must outlive it.
class CoupledNewton {
 public:
  explicit CoupledNewton(const RobotDescription& robot) : robot_(robot), linear_(robot), cables_(robot.cables.size()) {}

  // False: a cable cannot be evaluated here.
  bool linearise(const Wrench& external, Steps steps, CoupledState* state);

  // The step that closes every cable and balances the platform, to first order, without the motions that nothing
  // resists. False where the stiffness is not finite.
  bool solve();

  // Moves a state that has converged since it was linearised to where other lengths [m], in the robot's order, and
  // another load put it: pose and ends exactly, each cable's force by its ChordLaw. Returns the size of the move,
  // relative as size(); infinity where there is no such place.
  double predict(const std::vector<double>& lengths, const Wrench& external, CoupledState* state);

  // Size of the step, relative: forces, angles along cables, pose.
  double size(const CoupledState& state) const;
  // True if what is left to correct is rounding.
  bool atRounding() const;
  // Of the state that was linearised last, before any step from there.
  Residuals residuals() const;

  // Takes the step, damped where it is out of Newton's reach.
  void step(CoupledState* state) const;

  // Total wrench's derivative with respect to (translation, rotation vector), at fixed lengths.
  const Eigen::Matrix<double, 6, 6>& stiffness() const { return linear_.stiffness(); }

 private:
  // A cable's share of the linearised problem: (H, V) change by start + stiffness * (change of the end in the plane).
  struct Elimination {
    CablePlane plane;
    Eigen::Matrix2d stiffness;  // d(H, V)/d(x, y)
    Eigen::Vector2d by_length;  // d(H, V)/dL at fixed ends
    Eigen::Vector2d start;      // what closes the cable at this pose
    Eigen::Matrix2d at_b;       // of the forces at B by those at A, see forcesAtB()
  };

  Eigen::Vector3d change(const Elimination& e) const;
  // The pose that the laws of the cables put the platform at, and (H, V) of every cable there. False: there is none.
  bool predictPose(const Wrench& external, Pose* pose);

  const RobotDescription& robot_;
  LinearRobot linear_;
  std::vector<Elimination> cables_;
  std::vector<ChordLaw> laws_;           // of a prediction
  std::vector<Eigen::Vector2d> forces_;  // (H, V) of a prediction
  Wrench unbalanced_ = Wrench::Zero();   // once every cable is closed
  Wrench pose_step_ = Wrench::Zero();
  double closure_defect_ = 0.0;  // largest one, relative to the cable's length
  double open_ = 0.0;            // largest distance of a cable's end from its attachment [m]
};

struct CoupledOptions {
  double tolerance = 1e-8;  // forces change by less than this times the tension
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  int max_iterations = 50;
};

// From a state near the solution, with a workspace that keeps the last linearisation: the solution's stiffness, and
// what a prediction needs.
SearchOutcome solveCoupled(const Wrench& external, const CoupledOptions& options, CoupledNewton* newton,
                           CoupledState* state);

// True if the platform does not leave its pose and every cable is in its sagging equilibrium.
bool isOnBranch(const PlatformStability& stability, const CoupledState& state);

}  // namespace cdpr_kinetostatics
