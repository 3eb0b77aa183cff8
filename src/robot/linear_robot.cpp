#include "robot/linear_robot.h"

#include <Eigen/SVD>

namespace cdpr_kinetostatics {
namespace {

// A reciprocal condition number below this leaves no digit of a displacement right.
constexpr double kSingular = 1e-15;

// Singular values of less than this share of the largest are its rounding.
constexpr double kRounding = 1e-12;
constexpr double kOpenShare = 1e-7;

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

LinearRobot::Stiffness LinearRobot::scaled() const {
  if (rigid_) return scale_.asDiagonal() * stiffness_ * scale_.asDiagonal();
  // A point mass does not turn. Rotations as stiff as its translations take no part and hide no singularity.
  Stiffness translations = Stiffness::Zero();
  translations.topLeftCorner<3, 3>() = stiffness_.topLeftCorner<3, 3>();
  translations.diagonal().tail<3>().setConstant(stiffness_.topLeftCorner<3, 3>().norm());
  return translations;
}

bool LinearRobot::factorise() {
  has_open_motions_ = false;
  if (!stiffness_.allFinite()) return false;
  lu_.compute(scaled());
  return lu_.rcond() > kSingular;
}

bool LinearRobot::factoriseWithOpenMotions() {
  if (!stiffness_.allFinite()) return false;
  const Eigen::JacobiSVD<Stiffness> svd(scaled(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Wrench& values = svd.singularValues();
  const double rounding = kRounding * values(0);
  if (((values.array() <= rounding) && (values.array() > openStiffness(robot_))).any()) return false;
  const Wrench inverse = (values.array() > rounding).select(values.cwiseInverse(), 0.0);
  pseudo_inverse_ = svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose();
  has_open_motions_ = true;
  return true;
}

double openStiffness(const RobotDescription& robot) {
  return kOpenShare * robot.weight() / (robot.freedoms() == 6 ? robot.lever() : robot.span());
}

}  // namespace cdpr_kinetostatics
