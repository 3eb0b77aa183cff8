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

  // Where unbalanced wrenches, the columns, take the platform: translation, and rotation times lever() [m]. Needs
  // factorise().
  template <int Columns>
  Eigen::Matrix<double, 6, Columns> displacement(const Eigen::Matrix<double, 6, Columns>& wrenches) const {
    Eigen::Matrix<double, 6, Columns> moved = lu_.solve(-(scale_.asDiagonal() * wrenches));
    if (!rigid_) moved.template bottomRows<3>().setZero();
    return moved;
  }

  // RobotDescription::lever() [m].
  double lever() const { return lever_; }

 private:
  const RobotDescription& robot_;
  const bool rigid_;
  const double lever_;
  Wrench scale_ = Wrench::Ones();  // moments count as forces at the lever
  Stiffness stiffness_ = Stiffness::Zero();
  Eigen::PartialPivLU<Stiffness> lu_;
};

// True if no motion of the platform is unstable: the symmetric part of the stiffness is negative definite.
bool isStable(const RobotDescription& robot, const LinearRobot::Stiffness& stiffness);

}  // namespace cdpr_kinetostatics
