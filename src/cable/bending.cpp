#include "cdpr_kinetostatics/cable/bending.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxNewtonIterations = 40;
constexpr int kMaxPathSteps = 400;
constexpr int kMaxPositionIterations = 60;
constexpr int kMaxLoopSteps = 40;
// While problem 1 moves the end point: its longest and shortest move, as shares of the length, and the share of the
// buckling load from which a compressed cable is taken for a strut rather than for a loop.
constexpr double kLongestMove = 0.1;
constexpr double kShortestMove = 1e-9;
constexpr double kStrutShare = 0.3;

// Node angles move at most this much in one Newton step [rad].
constexpr double kMaxAngleStep = 0.7;

// Below this angle change the integration steps are frozen, and Newton's method converges to rounding.
constexpr double kFreezeBelow = 1e-3;
// They are frozen after so many iterations in any case: where a cable hardly stretches, its forces magnify the
// error of integration, and would jitter with the steps for ever.
constexpr int kAdaptiveIterations = 10;

// A shape that turns by more than this has a loop in it. The largest turn without one is the teardrop of a
// weightless elastica whose ends touch, 261 degrees.
constexpr double kLoopAngle = 1.65 * M_PI;

// The catenary is a safe start where it spans this many bending layers ...
constexpr double kSafeLayers = 40.0;
// ... and its sharpest bend, radius R, satisfies (lambda/R)^2 below this.
constexpr double kSafeBend = 0.01;
// Width to which slack cables are opened at most, over that of a straight line of the same length and height; opening
// takes at most so many steps by this factor.
constexpr double kWide = 0.6;
constexpr double kOpening = 1.3;
constexpr int kOpenings = 44;
// A start that is not safe enough is made softer by this factor, so many times.
constexpr double kSofter = 0.03;
constexpr int kMostSofter = 6;
// Beyond this bend the catenary is not tried as a direct start.
constexpr double kSharpBend = 1.0;

// Problem 1 by a single shot from every angle at A: up to this many bending layers, with so many angles, and so
// many bisections where the moment at B changes sign.
constexpr double kScanLayers = 8.0;
constexpr int kScanAngles = 90;
constexpr int kScanBisections = 12;
constexpr double kScanTolerance = 1e-6;

// Forces are told apart down to this share of the cable's buckling load.
constexpr double kLeastForce = 1e-3;

// What the outer problem asks of a Newton iteration.
enum class Goal { kEndPoint, kForces };

struct NewtonTarget {
  Goal goal = Goal::kEndPoint;
  double length = 0.0;
  Eigen::Vector2d value = Eigen::Vector2d::Zero();  // (x, w) or (H, V)
};

// (lambda/R)^2 at the point of the catenary that bends most.
double sharpestBend(const CableProperties& cable, double length, const ForcesAtA& f) {
  const bool bottom_inside = f.vertical > 0.0 && f.vertical < cable.weight * length;
  const double v = bottom_inside ? 0.0 : std::min(std::abs(f.vertical), std::abs(f.vertical - cable.weight * length));
  const double t = std::hypot(f.horizontal, v);
  const double turn = cable.weight * f.horizontal / (t * t);
  if (t == 0.0) return std::numeric_limits<double>::infinity();
  return cable.bending_stiffness / t * turn * turn;
}

BendingOutcome newton(const NewtonTarget& target, const BendingOptions& options, int max_iterations,
                      MultipleShooting* shooting) {
  BendingOutcome outcome;
  bool adapt = true;
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < max_iterations; ++i) {
    if (std::chrono::steady_clock::now() > options.deadline) {
      outcome.status = {Code::kTimedOut, "the time allowed ran out while joining the cable's segments"};
      return outcome;
    }
    ++outcome.iterations;
    if (!shooting->linearise(adapt)) break;
    Eigen::Vector3d change(0.0, 0.0, target.length - shooting->length());
    if (target.goal == Goal::kEndPoint) {
      const Eigen::Matrix<double, 2, 3>& jacobian = shooting->end().jacobian;
      const Eigen::Vector2d defect = target.value - shooting->end().position - jacobian.col(2) * change.z();
      change.head<2>() = jacobian.leftCols<2>().inverse() * defect;
      outcome.closure_residual = defect.norm();
    } else {
      change.head<2>() = target.value - Eigen::Vector2d(shooting->horizontalForce(), shooting->verticalForceA());
    }
    if (!change.allFinite()) break;
    const double tension = std::max(std::hypot(shooting->horizontalForce(), shooting->verticalForceA()),
                                    kLeastForce * shooting->bucklingForce());
    const double angle = shooting->angleChange(change);
    const double size = std::max(angle, change.head<2>().norm() / tension);
    const double damping = std::min(1.0, kMaxAngleStep / angle);
    const bool at_rounding = outcome.closure_residual <= 1e-14 * target.length && angle <= options.tolerance;
    const bool stalled = size >= 0.5 * last_size && size < 1e-5;
    if (!adapt && (size <= options.tolerance || (stalled && at_rounding))) {
      shooting->step(change, damping);
      outcome.status.code = Code::kConverged;
      return outcome;
    }
    shooting->step(change, damping);
    adapt = size > kFreezeBelow && i < kAdaptiveIterations;
    last_size = size;
  }
  outcome.status = {Code::kNotConverged,
                    shooting->tooManySegments()
                        ? "the cable bends sharply over too many bending layers to be shot: a catenary is accurate here"
                        : "Newton's method did not join the cable's segments"};
  return outcome;
}

// A point of the path along which a safe problem becomes the one asked for.
struct PathPoint {
  CableProperties cable;
  double x = 0.0;
};

PathPoint between(const PathPoint& a, const PathPoint& b, double share) {
  PathPoint p = b;
  p.cable.bending_stiffness =
      a.cable.bending_stiffness * std::pow(b.cable.bending_stiffness / a.cable.bending_stiffness, share);
  p.cable.weight = a.cable.weight + share * (b.cable.weight - a.cable.weight);
  p.x = a.x + share * (b.x - a.x);
  return p;
}

// A problem whose answer is close to its catenary, at the same length and height difference.
std::optional<PathPoint> safeStart(const CableProperties& cable, double length, double x, double w, ForcesAtA* forces) {
  PathPoint start{cable, x};
  const double light = std::min(cable.bending_stiffness / std::pow(length, 3), 1e-4 * cable.axial_stiffness / length);
  start.cable.weight = std::max(cable.weight, light);
  // A slack cable is opened, but no wider than it takes to bend gently.
  const double longest = length * (1.0 + start.cable.weight * length / cable.axial_stiffness);
  const double wide = longest > std::abs(w) ? kWide * std::sqrt((longest - w) * (longest + w)) : 0.0;
  std::optional<ForcesAtA> catenary;
  for (int i = kOpenings; i >= 0; --i) {
    start.x = std::max(x, wide * std::pow(kOpening, -i));
    catenary = catenaryForces(start.cable, length, start.x, w);
    if (start.x >= wide || (catenary && sharpestBend(start.cable, length, *catenary) < kSafeBend)) break;
  }
  if (!catenary ||
      (catenary->horizontal == 0.0 && catenary->vertical >= 0.0 && catenary->vertical <= start.cable.weight * length)) {
    return std::nullopt;
  }
  *forces = *catenary;
  const double tension = std::hypot(forces->horizontal, forces->vertical);
  const double by_layers = tension * std::pow(length / kSafeLayers, 2);
  const double bend = sharpestBend(start.cable, length, *forces);
  const double by_bend = bend > 0.0 ? cable.bending_stiffness * kSafeBend / bend : by_layers;
  start.cable.bending_stiffness = std::min({cable.bending_stiffness, by_layers, by_bend});
  return start;
}

BendingOutcome continueFromCatenary(const CableProperties& cable, double length, double x, double w,
                                    const BendingOptions& options, MultipleShooting* shooting) {
  BendingOutcome outcome;
  ForcesAtA forces;
  std::optional<PathPoint> start = safeStart(cable, length, x, w, &forces);
  if (!start) {
    outcome.status = {Code::kNotConverged, "no catenary to start from"};
    return outcome;
  }
  const PathPoint goal{cable, x};
  for (int i = 0; i < kMostSofter; ++i, start->cable.bending_stiffness *= kSofter) {
    const int before = outcome.iterations;
    shooting->start(start->cable, length, forces.horizontal, forces.vertical, options.tolerance);
    outcome = newton({Goal::kEndPoint, length, {start->x, w}}, options, kMaxNewtonIterations, shooting);
    outcome.iterations += before;
    if (outcome.status.code == Code::kTimedOut || (outcome.status.ok() && onSaggingBranch(*shooting))) break;
  }
  if (!outcome.status.ok()) return outcome;

  MultipleShooting last = *shooting;
  double share = 0.0;
  double step = 0.25;
  for (int i = 0; i < kMaxPathSteps && share < 1.0; ++i) {
    const double next = std::min(1.0, share + step);
    const PathPoint point = between(*start, goal, next);
    if (start->cable.bending_stiffness != cable.bending_stiffness || start->cable.weight != cable.weight) {
      shooting->changeProperties(point.cable);
    }
    const BendingOutcome local = newton({Goal::kEndPoint, length, {point.x, w}}, options, 12, shooting);
    outcome.iterations += local.iterations;
    outcome.closure_residual = local.closure_residual;
    if (local.status.code == Code::kTimedOut) {
      outcome.status = local.status;
      return outcome;
    }
    if (local.status.ok() && onSaggingBranch(*shooting)) {
      last = *shooting;
      share = next;
      step *= 1.7;
    } else {
      shooting->restore(last);
      step *= 0.4;
      if (step < 1e-5) break;
    }
  }
  if (share < 1.0) {
    outcome.status = {Code::kNotConverged,
                      "the sagging equilibrium was lost on the way from the catenary to this bending stiffness"};
  }
  return outcome;
}

// Pulls all along, within rounding of a vertical cable.
bool hasTension(const CableProperties& cable, double length, const ForcesAtA& f) {
  const double outside = std::max(-f.vertical, f.vertical - cable.weight * length);
  return f.horizontal > 0.0 || (outside > 0.0 && f.horizontal >= -1e-12 * outside);
}

// Moves the end point from a start until the forces are those asked for.
BendingOutcome moveEndToForces(const CableProperties& cable, double length, const ForcesAtA& forces,
                               Eigen::Vector2d end, const BendingOptions& options, MultipleShooting* shooting) {
  BendingOutcome outcome = solveBendingForces(cable, length, end.x(), end.y(), options, shooting);
  const double scale = std::max(std::hypot(forces.horizontal, forces.vertical), cable.weight * length);
  double reach = kLongestMove * length;
  for (int i = 0; i < kMaxPositionIterations && outcome.status.ok(); ++i) {
    const Eigen::Vector2d missing(forces.horizontal - shooting->horizontalForce(),
                                  forces.vertical - shooting->verticalForceA());
    if (missing.norm() <= 1e-3 * scale) {
      const BendingOutcome last = followBendingPosition(length, forces, options, shooting);
      outcome.iterations += last.iterations;
      outcome.status = last.status;
      return outcome;
    }
    Eigen::Vector2d step = shooting->end().jacobian.leftCols<2>() * missing;
    step *= std::min(1.0, reach / step.norm());
    if (end.x() + step.x() < 0.0) step *= 0.5 * end.x() / -step.x();
    if (step.norm() < kShortestMove * length) break;
    const MultipleShooting last = *shooting;
    const BendingOutcome local = followBendingForces(length, end.x() + step.x(), end.y() + step.y(), options, shooting);
    outcome.iterations += local.iterations;
    if (local.status.code == Code::kTimedOut) {
      outcome.status = local.status;
      return outcome;
    }
    const double left =
        std::hypot(forces.horizontal - shooting->horizontalForce(), forces.vertical - shooting->verticalForceA());
    if (local.status.ok() && left <= 2.0 * missing.norm()) {
      end += step;
      reach = std::min(kLongestMove * length, 2.0 * reach);
    } else {
      shooting->restore(last);
      reach = 0.3 * step.norm();
    }
  }
  if (outcome.status.ok()) {
    outcome.status = {Code::kNotConverged, "no end point was found at which the cable carries these forces"};
  }
  return outcome;
}

// Problem 1 of a cable of few bending layers: every equilibrium under the forces is a start angle at A whose shot
// ends without moment, so all of them are found by looking around. The first sagging one is taken.
BendingOutcome scanStartAngles(const CableProperties& cable, double length, const ForcesAtA& forces,
                               const BendingOptions& options, MultipleShooting* shooting) {
  const auto momentAtB = [&](double angle) {
    return shooting->startFromAngle(cable, length, forces.horizontal, forces.vertical, angle, kScanTolerance);
  };
  BendingOutcome outcome;
  outcome.status = {Code::kNotConverged, "no sagging shape of the cable carries these forces"};
  double angle = -M_PI;
  std::optional<double> moment = momentAtB(angle);
  for (int i = 1; i <= kScanAngles && outcome.status.code == Code::kNotConverged; ++i) {
    const double last_angle = angle;
    const std::optional<double> last_moment = moment;
    angle = -M_PI + 2.0 * M_PI * i / kScanAngles;
    moment = momentAtB(angle);
    if (last_moment && moment && (*last_moment < 0.0) != (*moment < 0.0)) {
      double low = last_angle;
      double high = angle;
      for (int k = 0; k < kScanBisections; ++k) {
        const double middle = 0.5 * (low + high);
        const std::optional<double> there = momentAtB(middle);
        if (!there) break;
        ((*there < 0.0) == (*last_moment < 0.0) ? low : high) = middle;
      }
      if (!shooting->startFromAngle(cable, length, forces.horizontal, forces.vertical, 0.5 * (low + high),
                                    options.tolerance)) {
        continue;
      }
      const BendingOutcome local = newton({Goal::kForces, length, {forces.horizontal, forces.vertical}}, options,
                                          kMaxNewtonIterations, shooting);
      outcome.iterations += local.iterations;
      const bool found = local.status.ok() && shooting->end().position.x() >= 0.0 && onSaggingBranch(*shooting);
      if (found || local.status.code == Code::kTimedOut) outcome.status = local.status;
    }
  }
  return outcome;
}

// Problem 1 of a loop: pulled open by more horizontal force it bends as gently as its catenary; the force is then
// lowered to that asked for.
BendingOutcome closeLoop(const CableProperties& cable, double length, const ForcesAtA& forces,
                         const BendingOptions& options, MultipleShooting* shooting) {
  const double open = std::cbrt(cable.bending_stiffness * cable.weight * cable.weight / kSafeBend);
  shooting->start(cable, length, open, forces.vertical, options.tolerance);
  BendingOutcome outcome = followBendingPosition(length, {open, forces.vertical}, options, shooting);
  MultipleShooting last = *shooting;
  double share = 0.0;
  double step = 0.25;
  for (int i = 0; i < kMaxLoopSteps && outcome.status.ok() && share < 1.0; ++i) {
    const double next = std::min(1.0, share + step);
    const ForcesAtA at{open + next * (forces.horizontal - open), forces.vertical};
    const BendingOutcome local = followBendingPosition(length, at, options, shooting);
    outcome.iterations += local.iterations;
    if (local.status.code == Code::kTimedOut) outcome.status = local.status;
    if (local.status.ok() && shooting->end().position.x() >= -1e-12 * length && onSaggingBranch(*shooting)) {
      last = *shooting;
      share = next;
      step *= 1.7;
    } else {
      shooting->restore(last);
      step *= 0.4;
    }
  }
  if (outcome.status.ok() && share < 1.0) {
    outcome.status = {Code::kNotConverged, "the loop could not be closed to the horizontal force asked for"};
  }
  return outcome;
}

// Problem 1 through problem 2, from several end points in turn: a strut, nearly straight, if the cable is
// pushed hard; loops whose legs share the weight, from wide to narrow.
BendingOutcome searchEndOfForces(const CableProperties& cable, double length, const ForcesAtA& forces,
                                 const BendingOptions& options, MultipleShooting* shooting) {
  std::vector<Eigen::Vector2d> starts;
  const double buckling = cable.bending_stiffness * std::pow(M_PI / length, 2);
  const Eigen::Vector2d push(-forces.horizontal, forces.vertical - 0.5 * cable.weight * length);
  if (forces.horizontal < 0.0 && push.norm() > kStrutShare * buckling) {
    for (const double share : {0.97, 0.99, 0.999, 0.93, 0.85, 0.7})
      starts.emplace_back(share * length * push.normalized());
  }
  const double balance = cable.weight > 0.0 ? length - 2.0 * forces.vertical / cable.weight : 0.0;
  const double height = std::clamp(balance, -0.98 * length, 0.98 * length);
  for (const double share : {0.5, 0.9, 0.98, 0.2, 0.05, 0.01}) {
    starts.emplace_back(share * std::sqrt(length * length - height * height), height);
  }
  BendingOutcome outcome;
  int iterations = 0;
  for (const Eigen::Vector2d& start : starts) {
    outcome = moveEndToForces(cable, length, forces, start, options, shooting);
    iterations += outcome.iterations;
    if (outcome.status.ok() || outcome.status.code == Code::kTimedOut) break;
  }
  outcome.iterations = iterations;
  return outcome;
}

}  // namespace

bool onSaggingBranch(const MultipleShooting& shooting) {
  const double length = shooting.length();
  return shooting.stable() && shooting.areaBelowChord() >= -1e-10 * length * length &&
         std::abs(shooting.turning()) < kLoopAngle;
}

BendingOutcome solveBendingForces(const CableProperties& cable, double length, double x, double w,
                                  const BendingOptions& options, MultipleShooting* shooting) {
  BendingOutcome outcome;
  if (std::isinf(cable.axial_stiffness) && std::hypot(x, w) >= length) {
    outcome.status = {Code::kInfeasible, "an inextensible cable must be longer than the distance of its ends"};
    return outcome;
  }
  const std::optional<ForcesAtA> catenary = catenaryForces(cable, length, x, w);
  if (catenary && hasTension(cable, length, *catenary) && sharpestBend(cable, length, *catenary) < kSharpBend) {
    shooting->start(cable, length, catenary->horizontal, catenary->vertical, options.tolerance);
    outcome = newton({Goal::kEndPoint, length, {x, w}}, options, kMaxNewtonIterations, shooting);
    if (outcome.status.code == Code::kTimedOut || (outcome.status.ok() && onSaggingBranch(*shooting))) return outcome;
  }
  int direct_iterations = outcome.iterations;
  const double compression = std::isfinite(cable.axial_stiffness)
                                 ? cable.axial_stiffness * (1.0 - std::hypot(x, w) / length)
                                 : std::numeric_limits<double>::infinity();
  if (compression >= -cable.weight * length && compression < cable.bending_stiffness * std::pow(M_PI / length, 2)) {
    shooting->startStraight(cable, length, x, w, options.tolerance);
    outcome = newton({Goal::kEndPoint, length, {x, w}}, options, kMaxNewtonIterations, shooting);
    direct_iterations += outcome.iterations;
    outcome.iterations = direct_iterations;
    if (outcome.status.code == Code::kTimedOut || (outcome.status.ok() && onSaggingBranch(*shooting))) return outcome;
  }
  outcome = continueFromCatenary(cable, length, x, w, options, shooting);
  outcome.iterations += direct_iterations;
  return outcome;
}

BendingOutcome followBendingForces(double length, double x, double w, const BendingOptions& options,
                                   MultipleShooting* shooting) {
  BendingOutcome outcome = newton({Goal::kEndPoint, length, {x, w}}, options, 12, shooting);
  if (outcome.status.ok() && !onSaggingBranch(*shooting)) {
    outcome.status = {Code::kWrongBranch, "the cable snapped to another equilibrium"};
  }
  return outcome;
}

BendingOutcome followBendingPosition(double length, const ForcesAtA& forces, const BendingOptions& options,
                                     MultipleShooting* shooting) {
  return newton({Goal::kForces, length, {forces.horizontal, forces.vertical}}, options, kMaxNewtonIterations, shooting);
}

BendingOutcome solveBendingPosition(const CableProperties& cable, double length, const ForcesAtA& forces,
                                    const BendingOptions& options, MultipleShooting* shooting) {
  if (hasTension(cable, length, forces) && sharpestBend(cable, length, forces) < kSharpBend) {
    shooting->start(cable, length, forces.horizontal, forces.vertical, options.tolerance);
    const BendingOutcome outcome = followBendingPosition(length, forces, options, shooting);
    if (outcome.status.code == Code::kTimedOut || (outcome.status.ok() && onSaggingBranch(*shooting))) return outcome;
  }
  const double force = std::max(std::hypot(forces.horizontal, forces.vertical),
                                std::hypot(forces.horizontal, forces.vertical - cable.weight * length));
  if (length * std::sqrt(force / cable.bending_stiffness) < kScanLayers) {
    const BendingOutcome outcome = scanStartAngles(cable, length, forces, options, shooting);
    if (outcome.status.code != Code::kNotConverged) return outcome;
  }
  if (forces.vertical > 0.0 && forces.vertical < cable.weight * length) {
    const BendingOutcome outcome = closeLoop(cable, length, forces, options, shooting);
    if (outcome.status.code != Code::kNotConverged) return outcome;
  }
  return searchEndOfForces(cable, length, forces, options, shooting);
}

}  // namespace cdpr_kinetostatics
