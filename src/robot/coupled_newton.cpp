#include "robot/coupled_newton.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cable/iteration_schedule.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

// Farthest that the platform moves in one iteration: a share of the robot's span, and an angle.
constexpr double kMaxShareOfSpan = 0.05;
constexpr double kMaxRotation = 0.2;  // [rad]

using Matrix6 = Eigen::Matrix<double, 6, 6>;
// The rows and columns of the robot's freedoms, on the stack.
using MatrixOfFreedoms = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

// Newton steps of a prediction: one for the lengths, one for the circles that the cables' ends move on.
constexpr int kPredictorIterations = 2;
constexpr double kNowhere = std::numeric_limits<double>::infinity();

// Share of the cable's length: nearer to the vertical through A than that, H/x does not change as B moves.
constexpr double kLeastDistance = 1e-9;

}  // namespace

bool CoupledNewton::linearise(const Wrench& external, Steps steps, CoupledState* state) {
  unbalanced_ = loadWrench(robot_, state->pose, external);
  stiffness_ = weightStiffness(robot_, state->pose);
  closure_defect_ = 0.0;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    SaggingCable& cable = state->cables[i];
    const bool adapt = steps == Steps::kNew || (steps == Steps::kNewWhereDue && !cable.stepsFit());
    if (!cable.linearise(adapt)) return false;
    Elimination& e = cables_[i];
    e.plane = cablePlane(robot_.cables[i], state->pose);
    const Eigen::Matrix<double, 2, 3>& jacobian = cable.end().jacobian;
    e.stiffness = jacobian.leftCols<2>().inverse();
    e.by_length = -e.stiffness * jacobian.col(2);
    const Eigen::Vector2d defect = Eigen::Vector2d(e.plane.x, e.plane.y) - cable.end().position;
    closure_defect_ = std::max(closure_defect_, defect.norm() / cable.length());
    e.start = e.stiffness * defect;

    const double weight = cable.properties().weight * cable.length();
    const double h = cable.horizontalForce() + e.start.x();
    const Eigen::Vector3d force = forceOnPlatform(e.plane, h, cable.verticalForceA() + e.start.y(), weight);
    unbalanced_ += wrenchAt(e.plane.arm, force);
    addCableStiffness(e.plane, e.stiffness, force, forceDensity(e.plane, h, e.stiffness), &stiffness_);
  }
  return unbalanced_.allFinite() && stiffness_.allFinite();
}

bool CoupledNewton::solve() {
  Wrench scale = Wrench::Ones();
  Matrix6 scaled = stiffness_;
  if (robot_.freedoms() == 6) {
    scale.tail<3>().setConstant(1.0 / robot_.lever());
    scaled = scale.asDiagonal() * stiffness_ * scale.asDiagonal();
  } else {  // a point mass does not turn
    scaled.rightCols<3>().setZero();
    scaled.bottomRows<3>().setZero();
    scaled.bottomRightCorner<3, 3>().diagonal().setConstant(stiffness_.topLeftCorner<3, 3>().norm());
    unbalanced_.tail<3>().setZero();
  }
  const Eigen::PartialPivLU<Matrix6> lu(scaled);
  if (!(lu.rcond() > 1e-15)) return false;
  pose_step_ = scale.asDiagonal() * lu.solve(-(scale.asDiagonal() * unbalanced_));
  return pose_step_.allFinite();
}

// With the chord c (cos phi, sin phi) and the force f = (H, q L/2 - V), which for a light cable lies along it, the law
//     f = turn(phi - phi_0) [f_0 + df/dc (c - c_0) + (df/dphi - z x f_0) (phi - phi_0) + df/dL (L - L_0)]
// is exact for what makes a long step of a stiff cable nonlinear: that its end moves on a circle.
double CoupledNewton::predict(const std::vector<double>& lengths, const Wrench& external, CoupledState* state) {
  const auto quarter = [](const Eigen::Vector2d& v) { return Eigen::Vector2d(-v.y(), v.x()); };
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    Elimination& e = cables_[i];
    const SaggingCable& cable = state->cables[i];
    const CablePlane plane = cablePlane(robot_.cables[i], state->pose);
    Law& law = e.law;
    law.chord = std::hypot(plane.x, plane.y);
    law.along = Eigen::Vector2d(plane.x, plane.y) / law.chord;
    const double q = cable.properties().weight;
    const double length_change = lengths[i] - cable.length();
    const Eigen::Vector2d force(cable.horizontalForce(), 0.5 * q * cable.length() - cable.verticalForceA());
    const Eigen::Vector2d signs(1.0, -1.0);
    law.by_chord = signs.asDiagonal() * e.stiffness * law.along;
    law.by_turn = law.chord * (signs.asDiagonal() * e.stiffness * quarter(law.along)) - quarter(force);
    law.force = force + length_change * (signs.cwiseProduct(e.by_length) + Eigen::Vector2d(0.0, 0.5 * q));
  }
  Pose pose = state->pose;
  for (int iteration = 0; iteration <= kPredictorIterations; ++iteration) {
    unbalanced_ = loadWrench(robot_, pose, external);
    stiffness_ = weightStiffness(robot_, pose);
    for (std::size_t i = 0; i < cables_.size(); ++i) {
      Elimination& e = cables_[i];
      const Law& law = e.law;
      e.plane = cablePlane(robot_.cables[i], pose);
      const double chord = std::hypot(e.plane.x, e.plane.y);
      const Eigen::Vector2d along = Eigen::Vector2d(e.plane.x, e.plane.y) / chord;
      Eigen::Matrix2d turn;
      turn.col(0) << along.dot(law.along), law.along.x() * along.y() - law.along.y() * along.x();
      turn.col(1) = quarter(turn.col(0));
      const double angle = std::asin(turn(1, 0));
      const Eigen::Vector2d force = turn * (law.force + (chord - law.chord) * law.by_chord + angle * law.by_turn);
      const Eigen::Vector2d by_turn = turn * law.by_turn + quarter(force);
      Eigen::Matrix2d stiffness =
          turn * law.by_chord * along.transpose() + by_turn / chord * quarter(along).transpose();
      stiffness.row(1) *= -1.0;
      const double weight = state->cables[i].properties().weight * lengths[i];
      e.start << force.x(), 0.5 * weight - force.y();  // (H, V)
      const Eigen::Vector3d pull = forceOnPlatform(e.plane, e.start.x(), e.start.y(), weight);
      unbalanced_ += wrenchAt(e.plane.arm, pull);
      addCableStiffness(e.plane, stiffness, pull, forceDensity(e.plane, e.start.x(), stiffness), &stiffness_);
    }
    if (iteration == kPredictorIterations) break;
    if (!unbalanced_.allFinite() || !stiffness_.allFinite() || !solve()) return kNowhere;
    pose = displaced(pose, pose_step_.head<3>(), pose_step_.tail<3>());
  }
  double size = std::max((pose.position - state->pose.position).norm() / robot_.span(),
                         pose.orientation.angularDistance(state->pose.orientation));
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    SaggingCable& cable = state->cables[i];
    const Eigen::Vector3d change(cables_[i].start.x() - cable.horizontalForce(),
                                 cables_[i].start.y() - cable.verticalForceA(), lengths[i] - cable.length());
    size = std::max({size, change.head<2>().norm() / cable.tensionA()});
    if (!change.allFinite()) return kNowhere;
    cable.follow(change);
  }
  state->pose = pose;
  return size;
}

Eigen::Vector3d CoupledNewton::change(const Elimination& e) const {
  const Eigen::Vector3d moved = pose_step_.head<3>() + pose_step_.tail<3>().cross(e.plane.arm);
  const Eigen::Vector2d forces = e.start + e.stiffness * Eigen::Vector2d(e.plane.direction.dot(moved), moved.z());
  return {forces.x(), forces.y(), 0.0};
}

double CoupledNewton::size(const CoupledState& state) const {
  double size = std::max(pose_step_.head<3>().norm() / robot_.span(), pose_step_.tail<3>().norm());
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const SaggingCable& cable = state.cables[i];
    const Eigen::Vector3d step = change(cables_[i]);
    size = std::max({size, step.head<2>().norm() / cable.tensionA(), cable.angleChange(step)});
  }
  return size;
}

bool CoupledNewton::atRounding() const {
  return closure_defect_ < 1e-13 && unbalanced_.head(robot_.freedoms()).norm() < 1e-9 * robot_.weight();
}

void CoupledNewton::step(CoupledState* state) const {
  double damping = 1.0;
  const double translation = pose_step_.head<3>().norm();
  const double rotation = pose_step_.tail<3>().norm();
  if (translation > kMaxShareOfSpan * robot_.span()) damping = kMaxShareOfSpan * robot_.span() / translation;
  if (rotation > kMaxRotation) damping = std::min(damping, kMaxRotation / rotation);
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    damping = std::min(damping, state->cables[i].dampingFor(change(cables_[i])));
  }
  state->pose = displaced(state->pose, damping * pose_step_.head<3>(), damping * pose_step_.tail<3>());
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    // H/x, the horizontal force density, is what stays smooth where B passes below A: it is stepped, and
    // H follows from the new x.
    SaggingCable& cable = state->cables[i];
    const Elimination& e = cables_[i];
    const Eigen::Vector3d moved = pose_step_.head<3>() + pose_step_.tail<3>().cross(e.plane.arm);
    const double density = forceDensity(e.plane, cable.horizontalForce(), e.stiffness);
    Eigen::Vector3d step = change(e);
    const double least = kLeastDistance * cable.length();
    const double density_step =
        e.plane.x > least ? (step.x() - density * e.plane.direction.dot(moved)) / e.plane.x : 0.0;
    const double new_x = cablePlane(robot_.cables[i], state->pose).x;
    step.x() = ((density + damping * density_step) * new_x - cable.horizontalForce()) / damping;
    cable.step(step, damping);
  }
}

void readForces(const CoupledState& state, RobotForces* forces) {
  forces->pose = state.pose;
  forces->lengths.clear();
  forces->forces.clear();
  for (const SaggingCable& cable : state.cables) {
    forces->lengths.push_back(cable.length());
    forces->forces.push_back({cable.horizontalForce(), cable.verticalForceA()});
  }
}

CoupledOutcome solveCoupled(const RobotDescription& robot, const Wrench& external, const CoupledOptions& options,
                            CoupledState* state) {
  CoupledOutcome outcome;
  CoupledNewton newton(robot);
  bool adapt = true;
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < options.max_iterations; ++i) {
    if (std::chrono::steady_clock::now() > options.deadline) {
      outcome.status = {Code::kTimedOut, "the time allowed ran out while the platform's pose was refined"};
      return outcome;
    }
    ++outcome.iterations;
    if (!newton.linearise(external, adapt ? Steps::kNew : Steps::kKept, state)) break;
    outcome.stiffness = newton.stiffness();
    if (!newton.solve()) {
      outcome.status = {
          Code::kNotConverged,
          "the robot's stiffness is singular here: the cables leave the platform a free motion, or cannot give at all"};
      return outcome;
    }
    const double size = newton.size(*state);
    newton.step(state);
    if (!adapt && (size <= options.tolerance || (hasStoppedShrinking(size, last_size) && newton.atRounding()))) {
      outcome.status.code = Code::kConverged;
      return outcome;
    }
    adapt = choosesStepsNext(size, i);
    last_size = size;
  }
  outcome.status = {Code::kNotConverged, "Newton's method on the platform's pose did not converge"};
  return outcome;
}

bool isStable(const RobotDescription& robot, const Matrix6& stiffness) {
  const int n = robot.freedoms();
  const MatrixOfFreedoms hessian = -0.5 * (stiffness + stiffness.transpose()).topLeftCorner(n, n);
  return hessian.llt().info() == Eigen::Success;
}

bool isOnBranch(const RobotDescription& robot, const Matrix6& stiffness, const CoupledState& state) {
  return isStable(robot, stiffness) && std::all_of(state.cables.begin(), state.cables.end(),
                                                   [](const SaggingCable& cable) { return cable.onBranch(); });
}

}  // namespace cdpr_kinetostatics
