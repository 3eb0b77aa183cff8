#include "cdpr_kinetostatics/robot/coupled_newton.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cdpr_kinetostatics/cable/cable_evaluation.h"
#include "cdpr_kinetostatics/robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxIterations = 50;

// Farthest that the platform moves in one iteration: a share of the robot's span, and an angle.
constexpr double kMaxShareOfSpan = 0.05;
constexpr double kMaxRotation = 0.2;  // [rad]

// Below this size of a step the integration of bending cables keeps its grid.
constexpr double kFreezeBelow = 1e-3;
// And after so many iterations in any case: forces of cables that hardly stretch jitter with the grid.
constexpr int kAdaptiveIterations = 10;

// A cable's share of the linearised problem: (H, V) change by start + by_pose * (translation, rotation).
struct Elimination {
  CableLine line;
  Eigen::Vector2d start;
  Eigen::Matrix<double, 2, 6> by_pose;
};

using Matrix6 = Eigen::Matrix<double, 6, 6>;

class CoupledNewton {
 public:
  CoupledNewton(const RobotDescription& robot, const Wrench& external, CoupledState* state)
      : robot_(robot), external_(external), state_(*state), cables_(robot.cables.size()) {}

  bool linearise(bool adapt);
  Matrix6 stiffness() const { return stiffness_; }

  // Solves for the pose's step. False where the stiffness is singular.
  bool solve();

  // Size of the step, relative: forces, angles along cables, pose.
  double size() const;
  // True if what is left to correct is rounding.
  bool atRounding() const;
  void step();

 private:
  Eigen::Vector3d change(std::size_t i) const {
    Eigen::Vector3d force_and_length(0.0, 0.0, 0.0);
    force_and_length.head<2>() = cables_[i].start + cables_[i].by_pose * pose_step_;
    return force_and_length;
  }

  const RobotDescription& robot_;
  const Wrench external_;
  CoupledState& state_;
  std::vector<Elimination> cables_;
  Wrench unbalanced_;
  Matrix6 stiffness_;
  Wrench pose_step_ = Wrench::Zero();
  double closure_defect_ = 0.0;
};

bool CoupledNewton::linearise(bool adapt) {
  unbalanced_ = loadWrench(robot_, state_.pose, external_);
  stiffness_ = weightStiffness(robot_, state_.pose);
  closure_defect_ = 0.0;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    SaggingCable& cable = state_.cables[i];
    if (!cable.linearise(adapt)) return false;
    Elimination& e = cables_[i];
    e.line = cableLine(robot_.cables[i], state_.pose);
    const Eigen::Vector3d& direction = e.line.direction;

    Eigen::Matrix<double, 3, 6> motion;  // of B
    motion << Eigen::Matrix3d::Identity(), -cross(e.line.arm);
    Eigen::Matrix<double, 2, 3> in_plane;
    in_plane << direction.transpose(), Eigen::RowVector3d::UnitZ();
    const Eigen::Matrix2d stiffness = cable.end().jacobian.leftCols<2>().inverse();
    const Eigen::Vector2d defect = Eigen::Vector2d(e.line.x, e.line.w) - cable.end().position;
    closure_defect_ = std::max(closure_defect_, defect.norm() / cable.length());
    e.start = stiffness * defect;
    e.by_pose = stiffness * in_plane * motion;

    const double weight = cable.properties().weight * cable.length();
    const double h = cable.horizontalForce() + e.start.x();
    const Eigen::Vector3d force = forceOnPlatform(e.line, h, cable.verticalForceA() + e.start.y(), weight);
    Eigen::Matrix<double, 3, 2> to_world;
    to_world << -direction, Eigen::Vector3d::UnitZ();
    // The plane turns with B: a stiffness H/x across it.
    const double across = h / std::max(e.line.x, 1e-9 * cable.length());
    const Eigen::Vector3d side(-direction.y(), direction.x(), 0.0);
    const Eigen::Matrix3d point_stiffness = to_world * stiffness * in_plane - across * side * side.transpose();
    const Eigen::Matrix<double, 3, 6> force_by_pose = point_stiffness * motion;
    unbalanced_ += wrenchAt(e.line.arm, force);
    stiffness_.topRows<3>() += force_by_pose;
    stiffness_.bottomRows<3>() += cross(e.line.arm) * force_by_pose;
    stiffness_.bottomRightCorner<3, 3>() += cross(force) * cross(e.line.arm);
  }
  return unbalanced_.allFinite() && stiffness_.allFinite();
}

bool CoupledNewton::solve() {
  const int n = robot_.freedoms();
  const double radius = n == 6 ? std::max(robot_.platformRadius(), 1e-6 * robot_.span()) : 1.0;
  Wrench scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / radius);
  const Matrix6 scaled = scale.asDiagonal() * stiffness_ * scale.asDiagonal();
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(scaled.topLeftCorner(n, n));
  if (lu.rcond() < 1e-15) return false;
  pose_step_.setZero();
  pose_step_.head(n) = lu.solve(-(scale.asDiagonal() * unbalanced_).head(n));
  pose_step_ = scale.asDiagonal() * pose_step_;
  return pose_step_.allFinite();
}

double CoupledNewton::size() const {
  double size = std::max(pose_step_.head<3>().norm() / robot_.span(), pose_step_.tail<3>().norm());
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const SaggingCable& cable = state_.cables[i];
    const Eigen::Vector3d step = change(i);
    size = std::max({size, step.head<2>().norm() / cable.tensionA(), cable.angleChange(step)});
  }
  return size;
}

bool CoupledNewton::atRounding() const {
  return closure_defect_ < 1e-13 && unbalanced_.head(robot_.freedoms()).norm() < 1e-9 * robot_.weight();
}

void CoupledNewton::step() {
  double damping = 1.0;
  const double translation = pose_step_.head<3>().norm();
  const double rotation = pose_step_.tail<3>().norm();
  if (translation > kMaxShareOfSpan * robot_.span()) damping = kMaxShareOfSpan * robot_.span() / translation;
  if (rotation > kMaxRotation) damping = std::min(damping, kMaxRotation / rotation);
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    damping = std::min(damping, state_.cables[i].dampingFor(change(i)));
  }
  state_.pose = displaced(state_.pose, damping * pose_step_.head<3>(), damping * pose_step_.tail<3>());
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    // H/x, the horizontal force density, is what stays smooth where B passes below A: it is stepped, and
    // H follows from the new x.
    SaggingCable& cable = state_.cables[i];
    const Elimination& e = cables_[i];
    const double x = std::max(e.line.x, 1e-9 * cable.length());
    const Eigen::Vector3d moved = pose_step_.head<3>() + pose_step_.tail<3>().cross(e.line.arm);
    const double density = cable.horizontalForce() / x;
    Eigen::Vector3d step = change(i);
    const double density_step = (step.x() - density * e.line.direction.dot(moved)) / x;
    const double new_x = std::max(cableLine(robot_.cables[i], state_.pose).x, 1e-9 * cable.length());
    step.x() = ((density + damping * density_step) * new_x - cable.horizontalForce()) / damping;
    cable.step(step, damping);
  }
}

}  // namespace

CoupledOutcome solveCoupled(const RobotDescription& robot, const Wrench& external, const CoupledOptions& options,
                            CoupledState* state) {
  CoupledOutcome outcome;
  CoupledNewton newton(robot, external, state);
  bool adapt = true;
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMaxIterations; ++i) {
    if (std::chrono::steady_clock::now() > options.deadline) {
      outcome.status = {Code::kTimedOut, "the time allowed ran out while the platform's pose was refined"};
      return outcome;
    }
    ++outcome.iterations;
    if (!newton.linearise(adapt)) break;
    outcome.stiffness = newton.stiffness();
    if (!newton.solve()) {
      outcome.status = {Code::kNotConverged,
                        "the robot's stiffness is singular here: the cables leave the platform a free motion"};
      return outcome;
    }
    const double size = newton.size();
    newton.step();
    if (!adapt && (size <= options.tolerance || (size < 1e-5 && size >= 0.5 * last_size && newton.atRounding()))) {
      outcome.status.code = Code::kConverged;
      return outcome;
    }
    adapt = size > kFreezeBelow && i < kAdaptiveIterations;
    last_size = size;
  }
  outcome.status = {Code::kNotConverged, "Newton's method on the platform's pose did not converge"};
  return outcome;
}

bool isStable(const RobotDescription& robot, const Matrix6& stiffness) {
  const int n = robot.freedoms();
  const Eigen::MatrixXd symmetric = 0.5 * (stiffness + stiffness.transpose()).topLeftCorner(n, n);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff() <
         0.0;
}

}  // namespace cdpr_kinetostatics
