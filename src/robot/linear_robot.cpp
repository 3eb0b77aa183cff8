#include "robot/linear_robot.h"

#include <Eigen/Cholesky>

namespace cdpr_kinetostatics {
namespace {

// A reciprocal condition number below this leaves no digit of a displacement right.
constexpr double kSingular = 1e-15;

}  // namespace

LinearRobot::LinearRobot(const RobotDescription& robot)
    : robot_(robot), rigid_(robot.type == PlatformType::kRigidBody), lever_(robot.lever()) {
  if (rigid_) scale_.tail<3>().setConstant(1.0 / lever_);
}

void LinearRobot::start(const Pose& pose) { stiffness_ = weightStiffness(robot_, pose); }

void LinearRobot::add(const CablePlane& plane, const Eigen::Matrix2d& stiffness, double h,
                      const Eigen::Vector3d& force) {
  addCableStiffness(plane, stiffness, force, forceDensity(plane, h, stiffness), &stiffness_);
}

bool LinearRobot::factorise() {
  if (!stiffness_.allFinite()) return false;
  if (rigid_) {
    lu_.compute(scale_.asDiagonal() * stiffness_ * scale_.asDiagonal());
  } else {
    // A point mass does not turn. Rotations as stiff as its translations take no part and hide no singularity.
    Stiffness translations = Stiffness::Zero();
    translations.topLeftCorner<3, 3>() = stiffness_.topLeftCorner<3, 3>();
    translations.diagonal().tail<3>().setConstant(stiffness_.topLeftCorner<3, 3>().norm());
    lu_.compute(translations);
  }
  return lu_.rcond() > kSingular;
}

bool isStable(const RobotDescription& robot, const LinearRobot::Stiffness& stiffness) {
  // The rows and columns of the robot's freedoms, on the stack.
  using MatrixOfFreedoms = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  const int n = robot.freedoms();
  const MatrixOfFreedoms hessian = -0.5 * (stiffness + stiffness.transpose()).topLeftCorner(n, n);
  return hessian.llt().info() == Eigen::Success;
}

}  // namespace cdpr_kinetostatics
