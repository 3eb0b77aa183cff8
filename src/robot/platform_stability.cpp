#include "robot/platform_stability.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <iomanip>
#include <sstream>

namespace cdpr_kinetostatics {
namespace {

// A stiffness of less than this share of the largest is the rounding of the others.
constexpr double kRounding = 1e-10;

// Parts of a motion below this share are left out of the sentence.
constexpr double kNamed = 1e-3;

void nameVector(const char* verb, const Eigen::Vector3d& vector, std::ostringstream* text) {
  const Eigen::Vector3d unit = vector.normalized();
  *text << verb << " (" << unit.x() + 0.0 << ", " << unit.y() + 0.0 << ", " << unit.z() + 0.0 << ")";
}

// "turns about (0, 1, 0) and moves along (1, 0, 0)", world axes.
std::string describeMotion(const RobotDescription& robot, const Wrench& motion) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3);
  const Wrench clean = motion.unaryExpr([](double part) { return std::abs(part) < 1e-9 ? 0.0 : part; });
  const double translation = clean.head<3>().norm();
  const double rotation = clean.tail<3>().norm() * robot.lever();
  const bool turns = rotation > kNamed * translation;
  const bool moves = translation > kNamed * rotation;
  if (turns) nameVector("turns about", clean.tail<3>(), &text);
  if (turns && moves) text << " and ";
  if (moves) nameVector("moves along", clean.head<3>(), &text);
  return text.str();
}

}  // namespace

PlatformStability platformStability(const RobotDescription& robot, const LinearRobot::Stiffness& stiffness) {
  PlatformStability stability;
  const int n = robot.freedoms();
  Wrench scale = Wrench::Ones();
  scale.tail<3>().setConstant(1.0 / robot.lever());
  const LinearRobot::Stiffness scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
  using MatrixOfFreedoms = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
  const MatrixOfFreedoms hessian = -0.5 * (scaled + scaled.transpose()).topLeftCorner(n, n);
  const double zero_by_weight = openStiffness(robot);
  // Most platforms are stable, and this is ten times as fast as their eigenvalues: the norm is no less than any.
  const double certain = std::max(kRounding * hessian.norm(), zero_by_weight);
  if ((hessian - certain * MatrixOfFreedoms::Identity(n, n)).llt().info() == Eigen::Success) return stability;
  const Eigen::SelfAdjointEigenSolver<MatrixOfFreedoms> eigen(hessian);
  const auto& values = eigen.eigenvalues();
  const double zero = std::max(kRounding * values.cwiseAbs().maxCoeff(), zero_by_weight);
  if (values(0) > zero) return stability;
  stability.kind = values(0) < -zero ? Stability::kUnstable : Stability::kNeutral;
  const Eigen::Index count = stability.kind == Stability::kUnstable ? 1 : (values.array() <= zero).count();
  for (Eigen::Index k = 0; k < count; ++k) {
    Wrench motion = Wrench::Zero();
    motion.head(n) = eigen.eigenvectors().col(k);
    stability.motions.emplace_back(scale.asDiagonal() * motion);
  }
  return stability;
}

Status describeStability(const RobotDescription& robot, const PlatformStability& stability) {
  if (stability.kind == Stability::kStable) return {Code::kConverged, ""};
  std::string motions;
  for (const Wrench& motion : stability.motions) {
    motions += (motions.empty() ? "it " : "; it ") + describeMotion(robot, motion);
  }
  if (stability.kind == Stability::kUnstable) {
    return {Code::kUnstable, "the equilibrium is unstable, the platform would leave this pose: " + motions};
  }
  return {Code::kConverged, "a freedom is open, no cable and no weight resists it: " + motions};
}

}  // namespace cdpr_kinetostatics
