// Newton's method on the whole robot at once: platform pose, forces of every cable, and the nodes inside
// every bending cable converge together (docs/theory.md section 5).
//
// Each iteration linearises every cable, eliminates its (H, V), and solves for the pose with the robot's
// 6x6 stiffness (3x3 for a point mass). Quadratic near a solution, local: the start comes from elsewhere.
#pragma once

#include <chrono>
#include <vector>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"
#include "robot/platform_statics.h"
#include "robot/robot_forces.h"

namespace cdpr_kinetostatics {

// The unknowns of a forward problem: pose, and the cables' forces and shapes at their lengths.
struct CoupledState {
  Pose pose;
  std::vector<SaggingCable> cables;  // in the robot's order; rungs may differ
};

// Pose, lengths and forces alone; allocates nothing if forces has held as many cables before.
void readForces(const CoupledState& state, RobotForces* forces);

// Whether bending cables choose their integration steps anew: never, all, or those whose steps no longer serve.
enum class Steps { kKept, kNew, kNewWhereDue };

// One linearisation after another; a workspace that allocates nothing after its first use. The robot and the state
// that was linearised last must outlive it.
class CoupledNewton {
 public:
  explicit CoupledNewton(const RobotDescription& robot) : robot_(robot), cables_(robot.cables.size()) {}

  // False: a cable cannot be evaluated here.
  bool linearise(const Wrench& external, Steps steps, CoupledState* state);

  // The step that closes every cable and balances the platform, to first order. False where the stiffness is
  // singular.
  bool solve();
  // Moves a state that has converged since it was linearised to where other lengths [m], in the robot's order, and
  // another load put it: pose and ends exactly, each cable's law to first order in the length and the slope of its
  // chord. Returns the size of the move, relative as size(); infinity where there is no such place.
  double predict(const std::vector<double>& lengths, const Wrench& external, CoupledState* state);

  // Size of the step, relative: forces, angles along cables, pose.
  double size(const CoupledState& state) const;
  // True if what is left to correct is rounding.
  bool atRounding() const;

  // Takes the step, damped where it is out of Newton's reach.
  void step(CoupledState* state) const;

  // Total wrench's derivative with respect to (translation, rotation vector), at fixed lengths.
  const Eigen::Matrix<double, 6, 6>& stiffness() const { return stiffness_; }

 private:
  // Of a cable's in-plane force where a prediction begins, at its new length.
  struct Law {
    double chord = 0.0;                        // [m]
    Eigen::Vector2d along;                     // unit vector
    Eigen::Vector2d force, by_chord, by_turn;  // by_turn: beyond turning with the chord
  };

  // A cable's share of the linearised problem: (H, V) change by start + by_pose * (translation, rotation).
  struct Elimination {
    CablePlane plane;
    Eigen::Matrix2d stiffness;  // d(H, V)/d(x, y)
    Eigen::Vector2d by_length;  // d(H, V)/dL at fixed ends
    Eigen::Vector2d start;
    Law law;
  };

  Eigen::Vector3d change(const Elimination& e) const;

  const RobotDescription& robot_;
  std::vector<Elimination> cables_;
  Wrench unbalanced_ = Wrench::Zero();
  Eigen::Matrix<double, 6, 6> stiffness_ = Eigen::Matrix<double, 6, 6>::Zero();
  Wrench pose_step_ = Wrench::Zero();
  double closure_defect_ = 0.0;
};

struct CoupledOptions {
  double tolerance = 1e-8;  // forces change by less than this times the tension
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
  int max_iterations = 50;
};

struct CoupledOutcome {
  Status status;
  int iterations = 0;
  // Total wrench's derivative with respect to (translation, rotation vector), at fixed lengths.
  Eigen::Matrix<double, 6, 6> stiffness = Eigen::Matrix<double, 6, 6>::Zero();
};

CoupledOutcome solveCoupled(const RobotDescription& robot, const Wrench& external, const CoupledOptions& options,
                            CoupledState* state);

// True if no motion of the platform is unstable: the symmetric part of the stiffness is negative definite.
bool isStable(const RobotDescription& robot, const Eigen::Matrix<double, 6, 6>& stiffness);

// The same, and every cable in its sagging equilibrium.
bool isOnBranch(const RobotDescription& robot, const Eigen::Matrix<double, 6, 6>& stiffness, const CoupledState& state);

}  // namespace cdpr_kinetostatics
