// The tensions of one iteration and their limits: folds, below which a cable cannot hang, and what contradicts what.
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "cable/tautness.h"
#include "robot/inverse_solve.h"

namespace cdpr_kinetostatics {
namespace {

// Below this multiple of its weight a cable may come near the least tension that can hold it.
constexpr double kNearFold = 3.0;

// Largest turn of a free attitude in one iteration.
constexpr double kMaxTurn = 0.2;  // [rad]

// Imbalance that counts as equilibrium, relative to the platform's weight.
constexpr double kBalance = 1e-9;

}  // namespace

TensionDistribution InverseSolve::distribute() {
  const auto n = static_cast<Eigen::Index>(cables_.size());
  const int rows = robot_.freedoms();
  const Eigen::Index variables = n + (free_turn_ ? 3 : 0);
  Wrench scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / robot_.lever());

  Wrench total = loadWrench(robot_, pose_, request_.external_wrench);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, variables);
  if (free_turn_) matrix.rightCols<3>() = weightStiffness(robot_, pose_).rightCols<3>();
  TensionProblem problem;
  problem.preferred = Eigen::VectorXd::Zero(variables);
  problem.weight = Eigen::VectorXd::Constant(variables, turn_weight_);
  problem.lower = Eigen::VectorXd::Constant(variables, -kMaxTurn);
  problem.upper = Eigen::VectorXd::Constant(variables, kMaxTurn);
  for (Eigen::Index i = 0; i < n; ++i) {
    const InverseCable& c = cables_[i];
    const double q = c.cable.properties().weight;
    Eigen::Matrix3d force_by_cable;  // by (H, V, L)
    force_by_cable << c.plane.forceByForces(), -q * Eigen::Vector3d::UnitZ();
    const double h = c.cable.horizontalForce() + c.start.x();
    const Eigen::Vector3d force =
        forceOnPlatform(c.plane, c.cable.horizontalForce(), c.cable.verticalForceA(), q * c.cable.length()) +
        force_by_cable * c.start;
    matrix.col(i) = wrenchAt(c.plane.arm, force_by_cable * c.by_tension);
    total += wrenchAt(c.plane.arm, force) - matrix.col(i) * c.cable.tensionA();
    if (free_turn_) {
      const Eigen::Vector3d side = c.plane.side();
      const double across = forceDensity(c.plane, h, c.by_end.topRows<2>());
      const Eigen::Matrix3d arm = cross(c.plane.arm);
      const Eigen::Matrix3d force_by_turn = force_by_cable * c.by_turn + across * side * side.transpose() * arm;
      matrix.topRightCorner<3, 3>() += force_by_turn;
      matrix.bottomRightCorner<3, 3>() += arm * force_by_turn + cross(force) * arm;
    }
    problem.preferred(i) = preferred_(i);
    problem.weight(i) = 1.0 / (robot_.cables[i].tension_max - robot_.cables[i].tension_min);
    problem.lower(i) = c.lower;
    problem.upper(i) = c.upper;
  }
  problem.matrix = (scale.asDiagonal() * matrix).topRows(rows);
  problem.wrench = -(scale.asDiagonal() * total).head(rows);
  // The limits reached last are mostly those reached again.
  const std::optional<TensionDistribution> likely =
      distributeAtLimits(problem, distribution_.at_lower, distribution_.at_upper);
  return likely ? *likely : distributeTensions(problem);
}

bool InverseSolve::isBalanced() const { return distribution_.imbalance <= kBalance * robot_.weight(); }

bool InverseSolve::nearFold(const InverseCable& c, double tension) const {
  return !isStraight(options_.model) &&
         tension < kNearFold * c.cable.properties().weight * std::hypot(c.plane.x, c.plane.y);
}

bool InverseSolve::beyondFold(const InverseCable& c) const {
  return !isStraight(options_.model) && c.by_tension.z() > 0.0 &&
         c.cable.length() >= kHangingExcess * std::hypot(c.plane.x, c.plane.y);
}

// A tension below the least one that can hold its cable has no length: raises the limit where that would be
// asked for. True if a limit was raised.
bool InverseSolve::raiseLimitsToFolds(const Eigen::VectorXd& tensions) {
  const RungOptions options = roughly();
  bool raised = false;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    InverseCable& c = cables_[i];
    const double tension = tensions(static_cast<Eigen::Index>(i));
    if (!nearFold(c, tension)) continue;
    const CableSolution at = lengthOnRung(robot_.cables[i].properties, c.plane.x, c.plane.y,
                                          std::max(tension, 1e-12 * c.upper), 0.0, options);
    if (at.status.ok() || at.least_tension <= c.lower) continue;
    c.lower = kAboveFold * at.least_tension;
    raised = true;
  }
  return raised;
}

// A cable that has stepped over its fold hangs in a deep loop, where more tension means more length: it starts
// anew on the taut side. True if there was one.
bool InverseSolve::pullBackFromFolds() {
  const RungOptions options = roughly();
  bool any = false;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    InverseCable& c = cables_[i];
    if (!beyondFold(c)) continue;
    const CableProperties& properties = robot_.cables[i].properties;
    CableSolution taut = lengthOnRung(properties, c.plane.x, c.plane.y, c.cable.tensionA(), 0.0, options);
    if (!taut.status.ok() && taut.least_tension > 0.0) {
      c.lower = std::max(c.lower, kAboveFold * taut.least_tension);
      taut = lengthOnRung(properties, c.plane.x, c.plane.y, c.lower, 0.0, options);
    }
    if (!taut.status.ok()) continue;
    c.cable.start(taut.length, {taut.horizontal_force, taut.vertical_force_a});
    any = true;
  }
  return any;
}

// A cable that pushes has no place in a solution with tension limits above zero.
Status InverseSolve::checkBranches() const {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const SaggingCable& cable = cables_[i].cable;
    if (cable.pushes() && robot_.cables[i].tension_min > 0.0) {
      return {Code::kInfeasible,
              "cable '" + robot_.cables[i].name + "' would be in compression, which its tension_min forbids"};
    }
    if (!cable.onBranch()) {
      return {Code::kWrongBranch,
              "cable '" + robot_.cables[i].name + "' ended in an equilibrium that is not the sagging one"};
    }
  }
  return {Code::kConverged, ""};
}

Status InverseSolve::contradiction(const TensionDistribution& distribution) const {
  std::ostringstream text;
  text << "no tensions within the limits balance the load at this pose; these limits cannot all be met:";
  const char* separator = " ";
  const auto n = static_cast<int>(cables_.size());
  for (const int i : distribution.at_lower) {
    if (i >= n) continue;
    const bool fold = cables_[i].lower > robot_.cables[i].tension_min;
    text << separator << "'" << robot_.cables[i].name << "' "
         << (fold ? "least tension that can hold the cable " : "tension_min ") << cables_[i].lower << " N";
    separator = ", ";
  }
  for (const int i : distribution.at_upper) {
    if (i >= n) continue;
    text << separator << "'" << robot_.cables[i].name << "' tension_max " << cables_[i].upper << " N";
    separator = ", ";
  }
  return {Code::kInfeasible, text.str()};
}

Status InverseSolve::unbalanced(double imbalance) const {
  std::ostringstream text;
  text << "the " << cables_.size()
       << " cables cannot balance the load at this pose, whatever their tensions: " << imbalance
       << " N is left (moments divided by the platform's radius)";
  if (!free_turn_ && robot_.type == PlatformType::kRigidBody) {
    text << "; with free_orientation the attitude is left to equilibrium";
  }
  return {Code::kInfeasible, text.str()};
}

}  // namespace cdpr_kinetostatics
