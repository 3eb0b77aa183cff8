// A robot to first order: its stiffness at a pose, and where an unbalanced wrench takes its platform.
//
// Newton's method on the whole robot steps by this, and what the cables' models leave out is judged by it
// (docs/theory.md section 5, equations (34), (35) and (37)).
#pragma once

#include <Eigen/LU>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {

// A workspace: using it again allocates nothing. The robot must outlive it.
class LinearRobot {
 public:
  using Stiffness = Eigen::Matrix<double, 6, 6>;

  explicit LinearRobot(const RobotDescription& robot);

  // Starts anew with the stiffness of the platform's weight at a pose.
  void start(const Pose& pose);

  // Adds a cable with in-plane stiffness d(H, V)/d(x, y), horizontal force h [N] and this force on the platform [N].
  void add(const CablePlane& plane, const Eigen::Matrix2d& stiffness, double h, const Eigen::Vector3d& force);

  // d(total wrench)/d(translation, rotation vector), at fixed lengths.
  const Stiffness& stiffness() const { return stiffness_; }

  // False where the stiffness is singular or not finite.
  bool factorise();

  // After factorise() has failed: leaves alone the motions that nothing resists, so that displacement() is the shortest
  // one. A wrench along such a motion stays unbalanced. False where the stiffness is not finite, and where something
  // resists so much more than the weight that its rounding hides the weight.
  bool factoriseWithOpenMotions();

  // Where unbalanced wrenches, the columns, take the platform: translation, and rotation times lever() [m]. Needs one
  // of the two above.
  template <int Columns>
  Eigen::Matrix<double, 6, Columns> displacement(const Eigen::Matrix<double, 6, Columns>& wrenches) const {
    const Eigen::Matrix<double, 6, Columns> resisted = -(scale_.asDiagonal() * wrenches);
    Eigen::Matrix<double, 6, Columns> moved =
        has_open_motions_ ? Eigen::Matrix<double, 6, Columns>(pseudo_inverse_ * resisted) : lu_.solve(resisted);
    if (!rigid_) moved.template bottomRows<3>().setZero();
    return moved;
  }

  // RobotDescription::lever() [m].
  double lever() const { return lever_; }

 private:
  const RobotDescription& robot_;
  const bool rigid_;
  const double lever_;
  Stiffness scaled() const;

  Wrench scale_ = Wrench::Ones();  // moments count as forces at the lever
  Stiffness stiffness_ = Stiffness::Zero();
  Eigen::PartialPivLU<Stiffness> lu_;
  bool has_open_motions_ = false;
  Stiffness pseudo_inverse_ = Stiffness::Zero();  // if it has
};

// A stiffness below this counts as none, for a motion whose rotations count with the lever: a ten-millionth of what the
// weight makes of a turn of 1 rad, which is what the tolerance of a solve leaves of zero [N/m].
double openStiffness(const RobotDescription& robot);

}  // namespace cdpr_kinetostatics
