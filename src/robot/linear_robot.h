// A robot in equilibrium, to first order: where an unbalanced wrench takes its platform.
#pragma once

#include <Eigen/LU>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {

class LinearRobot {
 public:
  LinearRobot(const RobotDescription& robot, const Pose& pose);

  // stiffness: d(H, V)/d(x, y).
  void add(const CablePlane& plane, const Eigen::Matrix2d& stiffness, double h, const Eigen::Vector3d& force);

  // False where the stiffness is singular.
  bool factorise();

  // Where unbalanced wrenches, the columns, take the platform: translation, and rotation times radius() [m].
  template <int Columns>
  Eigen::Matrix<double, 6, Columns> displacement(const Eigen::Matrix<double, 6, Columns>& wrenches) const {
    Eigen::Matrix<double, 6, Columns> moved = lu_.solve(-(scale_.asDiagonal() * wrenches));
    if (!rigid_) moved.template bottomRows<3>().setZero();
    return moved;
  }

  double radius() const { return radius_; }

 private:
  const double radius_;
  const bool rigid_;
  Eigen::Matrix<double, 6, 6> stiffness_;
  Wrench scale_ = Wrench::Ones();
  Eigen::PartialPivLU<Eigen::Matrix<double, 6, 6>> lu_;
};

}  // namespace cdpr_kinetostatics
