#include "robot/inverse_iteration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "robot/platform_statics.h"
#include "robot/straight_rope.h"
#include "robot/tension_limits.h"

namespace cdpr_kinetostatics {
namespace {

// A cable starts with a pull of at least this share of its weight, so taut that a parabola is near its catenary.
constexpr double kStartingPull = 1.0;
// And of at least this share of its upper limit: a weightless cable without tension has no shape.
constexpr double kLeastShare = 1e-9;

// Bending layers, L sqrt(T/EI), in which a cable's two ends know nothing of each other.
constexpr double kManyLayers = 10.0;

// Imbalance that counts as equilibrium, relative to the platform's weight.
constexpr double kBalance = 1e-9;

// A newton of imbalance costs this much more than the multipliers of equilibrium say: enough for its removal to count
// as progress.
constexpr double kPriceAboveMultipliers = 1.5;

// A newton of a cable's pull brings at most this much of imbalance, all components added: 3 of force, 3 of moment.
constexpr double kNewtonsPerPull = 6.0;

// Halvings of a step that brings nothing forward.
constexpr int kMostHalvings = 14;

// Smaller steps than this are taken as they are: what they bring is rounding.
constexpr double kSmallStep = 1e-6;

// Rounding of the merit, relative.
constexpr double kMeritRounding = 1e-13;

// A bending cable that is taut and many bending layers long has nearly the shape of its catenary. Any other one has
// another shape, too far off for Newton's method.
bool isNearCatenary(const InverseCable& catenary, const SaggingCable& cable) {
  const double layers = catenary.cable.length() * std::sqrt(catenary.tension / cable.properties().bending_stiffness);
  return catenary.slope > kTautOnPath && layers > kManyLayers;
}

// So stiff a cable that it pushes at this length starts as long as its chord.
bool startOnBranch(const InverseCable& catenary, const SolveLimits& limits, SaggingCable* cable) {
  const double x = catenary.plane.x;
  const double y = catenary.plane.y;
  if (cable->startBetween(catenary.cable.length(), x, y, limits).ok() && !cable->pushes()) return true;
  return cable->startBetween(straightRope(cable->properties(), x, y).length(), x, y, limits).ok();
}

}  // namespace

void InverseIteration::begin(const InverseRequest& request) {
  problem_.external = request.external_wrench;
  problem_.attitude = FreeAttitude(problem_.robot, request);
  pose_ = problem_.attitude.allowed(request.pose);
  problem_.preferred.resize(static_cast<Eigen::Index>(problem_.robot.cables.size()));
  for (Eigen::Index i = 0; i < problem_.preferred.size(); ++i) {
    const CableDescription& cable = problem_.robot.cables[i];
    problem_.preferred(i) = request.preferred_tensions.empty() ? 0.5 * (cable.tension_min + cable.tension_max)
                                                               : request.preferred_tensions[i];
  }
}

void InverseIteration::setAttitude(const Eigen::Quaterniond& attitude) {
  pose_.orientation = attitude;
  pose_ = problem_.attitude.allowed(pose_);
}

Status InverseIteration::startCables(Model closed_form, double tolerance) {
  if (Status reach = checkPulleys(problem_.robot, pose_); !reach.ok()) return reach;
  distribution_ = {};
  price_ = price_of_limits_ = 0.0;
  cables_.clear();
  for (std::size_t i = 0; i < problem_.robot.cables.size(); ++i) {
    const CableDescription& description = problem_.robot.cables[i];
    InverseCable cable;
    cable.cable = SaggingCable(description.properties, closed_form, tolerance);
    cable.plane = cablePlane(description, pose_);
    cable.lower = description.tension_min;
    cable.upper = description.tension_max;
    if (!(std::hypot(cable.plane.x, cable.plane.y) > 0.0)) {
      return {Code::kInvalidInput, "cable '" + description.name + "': its ends coincide at this pose"};
    }
    const CableProperties& seen = cable.cable.properties();
    const double tension = std::clamp(problem_.preferred(static_cast<Eigen::Index>(i)),
                                      std::max(cable.lower, kLeastShare * cable.upper), cable.upper);
    const StraightRope rope = straightRope(seen, cable.plane.x, cable.plane.y);
    const double chord = rope.chord();
    const double pull = std::max(tension, kStartingPull * seen.weight * chord);
    double free = chord / (1.0 + pull / seen.axial_stiffness);
    if (!isStraight(closed_form)) free *= 1.0 + std::pow(seen.weight * rope.free.x() / pull, 2) / 24.0;
    const ForcesAtA forces{pull * rope.free.x() / chord, 0.5 * seen.weight * free - pull * rope.free.y() / chord};
    cable.cable.start(free + (rope.wrapped - seen.dead_length * pull / seen.axial_stiffness), forces);
    cables_.push_back(std::move(cable));
  }
  return {Code::kConverged, ""};
}

void InverseIteration::useRungs(const std::vector<Model>& rungs, const SolveLimits& limits) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    InverseCable& c = cables_[i];
    if (c.cable.model() == rungs[i]) continue;
    SaggingCable cable(problem_.robot.cables[i].properties, rungs[i], limits.tolerance);
    if (!cable.bends() || isNearCatenary(c, cable) || !startOnBranch(c, limits, &cable)) {
      cable.start(c.cable.length(), {c.cable.horizontalForce(), c.cable.verticalForceA()});
    }
    c.cable = std::move(cable);
  }
}

bool InverseIteration::closeAt(const Eigen::VectorXd& pulls, const Eigen::Vector3d& turn, Steps steps) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const double pull = pulls(static_cast<Eigen::Index>(i));
    if (!cables_[i].close(problem_.robot.cables[i], pose_, steps, pull, turn)) return false;
  }
  return true;
}

// Near the branch's end a step may end on another one.
bool InverseIteration::keepsBranches() const {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const InverseCable& c = cables_[i];
    const bool taut = c.slope > kTautOnPath && !c.cable.pushes();
    if (!taut && !c.cable.onBranch() && before_[i].cable.onBranch()) return false;
  }
  return true;
}

bool InverseIteration::closeCables(Steps steps) {
  if (!linearise(steps, kTautInSearch)) return false;
  return closeAt(pulls(), Eigen::Vector3d::Zero(), steps);
}

bool InverseIteration::distribute(SolveLimits::Clock::time_point deadline) {
  const auto n = static_cast<int>(cables_.size());
  if (problem_.attitude.freedoms() == 0) {
    distributePulls(deadline);
  } else {
    const std::optional<QuadraticProgram> program =
        attitudeProgram(problem_, pose_, cables_, distribution_.multipliers);
    if (!program) return false;
    const QuadraticStep step = solveQuadraticProgram(*program, deadline);
    distribution_ = {};
    distribution_.tensions = step.change;
    for (int i = 0; i < n; ++i) distribution_.tensions(i) += cables_[i].pull;
    distribution_.feasible = step.feasible;
    distribution_.imbalance = step.imbalance;
    distribution_.largest_push = step.largest_push;
    if (step.feasible) distribution_.multipliers = step.multipliers;
    for (const int k : step.active) {
      if (k < n) distribution_.at_lower.push_back(k);
      if (k >= n && k < 2 * n) distribution_.at_upper.push_back(k - n);
    }
  }
  return true;
}

InverseIteration::Move InverseIteration::plannedMove() const {
  Move move;
  move.turn = distribution_.tensions.tail(problem_.attitude.freedoms());
  const Eigen::Vector3d turn = problem_.attitude.axes(pose_) * move.turn;
  move.size = turn.norm();
  for (std::size_t k = 0; k < cables_.size(); ++k) {
    const InverseCable& c = cables_[k];
    const double pull = distribution_.tensions(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d change = move.turn.size() == 0 ? c.change(pull) : c.change(pull, turn);
    move.finite = move.finite && change.allFinite();
    move.damping = std::min(move.damping, c.cable.dampingFor(change));
    move.size = std::max({move.size, c.size(change), c.cable.angleChange(change)});
  }
  return move;
}

// Where the limits cannot be met, the objective does not count.
double InverseIteration::merit() const {
  const double left = imbalance(problem_, pose_, cables_).lpNorm<1>();
  double beyond = 0.0;
  for (const InverseCable& c : cables_) beyond += c.beyondLimits();
  if (!distribution_.feasible) return left + kNewtonsPerPull * beyond;
  return objective(problem_, cables_) + price_ * left + price_of_limits_ * beyond;
}

bool InverseIteration::advance(const Move& move, Steps steps) {
  const auto n = static_cast<Eigen::Index>(cables_.size());
  if (distribution_.feasible && distribution_.multipliers.size() > 0) {
    price_ = std::max(price_, kPriceAboveMultipliers * distribution_.multipliers.cwiseAbs().maxCoeff());
  }
  price_of_limits_ = std::max(price_of_limits_, kPriceAboveMultipliers * distribution_.largest_push);
  before_ = cables_;
  const Pose pose = pose_;
  const double merit_before = merit() * (1.0 + kMeritRounding);
  const Eigen::VectorXd from = pulls();
  const Eigen::Vector3d turn = problem_.attitude.axes(pose) * move.turn;
  const Eigen::VectorXd way = distribution_.tensions.head(n) - from;
  // What no tensions can remove is no measure of a step.
  const bool searched = move.size >= kSmallStep && isBalanced();
  double share = 1.0;
  bool closed = false;
  for (int k = 0; k < kMostHalvings; ++k, share *= 0.5) {
    if (k > 0) cables_ = before_;
    pose_ = problem_.attitude.turned(pose, share * move.turn);
    closed = closeAt(from + share * way, share * turn, steps) && keepsBranches();
    if (closed && (!searched || merit() <= merit_before)) break;
  }
  return closed;
}

bool InverseIteration::linearise(Steps steps, double taut) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    if (!cables_[i].linearise(problem_.robot.cables[i], pose_, steps, taut)) return false;
  }
  return true;
}

Eigen::VectorXd InverseIteration::pulls() const {
  Eigen::VectorXd pulls(static_cast<Eigen::Index>(cables_.size()));
  for (std::size_t i = 0; i < cables_.size(); ++i) pulls(static_cast<Eigen::Index>(i)) = cables_[i].pull;
  return pulls;
}

// The limits reached last are mostly those reached again.
void InverseIteration::distributePulls(SolveLimits::Clock::time_point deadline) {
  const TensionProblem program = tensionProgram(problem_, pose_, cables_, distribution_.multipliers);
  std::optional<TensionDistribution> likely =
      distributeAtLimits(program, distribution_.at_lower, distribution_.at_upper);
  distribution_ = likely ? std::move(*likely) : distributeTensions(program, deadline);
}

void InverseIteration::take(const Move& move) {
  for (std::size_t k = 0; k < cables_.size(); ++k) {
    InverseCable& c = cables_[k];
    c.cable.step(c.change(distribution_.tensions(static_cast<Eigen::Index>(k))), move.damping);
  }
}

bool InverseIteration::isFeasible() const {
  return distribution_.feasible &&
         std::none_of(cables_.begin(), cables_.end(), [](const InverseCable& c) { return c.too_heavy; });
}

bool InverseIteration::isBalanced() const { return distribution_.imbalance <= kBalance * problem_.robot.weight(); }

Status InverseIteration::infeasible() const {
  return isFeasible() ? unbalanced() : contradiction(problem_.robot, cables_, distribution_);
}

Status InverseIteration::unbalanced() const {
  std::ostringstream text;
  text << "the " << cables_.size()
       << " cables cannot balance the load at this pose, whatever their tensions: " << distribution_.imbalance
       << " N is left (moments divided by the platform's radius)";
  if (problem_.attitude.freedoms() == 0 && problem_.robot.type == PlatformType::kRigidBody) {
    text << "; with free_orientation the attitude is left to equilibrium";
  }
  return {Code::kInfeasible, text.str()};
}

Residuals InverseIteration::residuals() const {
  Residuals residuals;
  Wrench total = loadWrench(problem_.robot, pose_, problem_.external);
  for (const InverseCable& c : cables_) {
    total += wrenchAt(c.plane.arm, c.force());
    residuals.closure = std::max(residuals.closure, c.open);
  }
  if (!total.allFinite() || !std::isfinite(residuals.closure)) return {};
  residuals.force = total.head<3>().norm();
  residuals.moment = problem_.robot.type == PlatformType::kPointMass ? 0.0 : total.tail<3>().norm();
  return residuals;
}

RobotForces InverseIteration::reached() const {
  RobotForces forces;
  forces.pose = pose_;
  for (const InverseCable& c : cables_) {
    forces.lengths.push_back(c.cable.length());
    forces.forces.push_back({c.cable.horizontalForce(), c.cable.verticalForceA()});
  }
  return forces;
}

}  // namespace cdpr_kinetostatics
