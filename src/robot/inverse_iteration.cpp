#include "robot/inverse_iteration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "robot/platform_statics.h"
#include "robot/tension_limits.h"

namespace cdpr_kinetostatics {
namespace {

// Weight of a turn of a free attitude in the objective: it decides only where equilibrium and tensions leave the
// attitude free. It grows by this factor where the turn swings.
constexpr double kTurnWeight = 1e-2;  // [1/rad]
constexpr double kHeavierTurn = 1.5;

// A tension of zero has no answer to problem 3: the least one to start from, as a share of the upper limit.
constexpr double kLeastShare = 1e-9;

// Imbalance that counts as equilibrium, relative to the platform's weight.
constexpr double kBalance = 1e-9;

// Raised limits move other tensions down to their folds; more than a few rounds are left to the next iteration.
constexpr int kRoundsOfFolds = 3;

}  // namespace

void InverseIteration::begin(const InverseRequest& request) {
  external_ = request.external_wrench;
  pose_ = request.pose;
  turn_ = {request.free_orientation && robot_.type == PlatformType::kRigidBody, kTurnWeight};
  preferred_.resize(static_cast<Eigen::Index>(robot_.cables.size()));
  for (Eigen::Index i = 0; i < preferred_.size(); ++i) {
    const CableDescription& cable = robot_.cables[i];
    preferred_(i) = request.preferred_tensions.empty() ? 0.5 * (cable.tension_min + cable.tension_max)
                                                       : request.preferred_tensions[i];
  }
}

Status InverseIteration::startCables(const RungOptions& closed_form, double tolerance) {
  distribution_ = {};
  cables_.clear();
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CableDescription& description = robot_.cables[i];
    InverseCable cable;
    cable.cable = SaggingCable(description.properties, closed_form.model, tolerance);
    cable.plane = cablePlane(description, pose_);
    cable.lower = description.tension_min;
    cable.upper = description.tension_max;
    const double tension = std::clamp(preferred_(static_cast<Eigen::Index>(i)),
                                      std::max(cable.lower, kLeastShare * cable.upper), cable.upper);
    const CableSolution start = lengthAboveFold(description.properties, tension, closed_form, &cable);
    if (!start.status.ok()) {
      return {start.status.code, "cable '" + description.name + "': " + start.status.message};
    }
    cable.cable.start(start.length, {start.horizontal_force, start.vertical_force_a});
    cables_.push_back(std::move(cable));
  }
  return {Code::kConverged, ""};
}

void InverseIteration::useRungs(const std::vector<Model>& rungs, double tolerance) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const SaggingCable& old = cables_[i].cable;
    if (old.model() == rungs[i]) continue;
    SaggingCable cable(robot_.cables[i].properties, rungs[i], tolerance);
    cable.start(old.length(), {old.horizontalForce(), old.verticalForceA()});
    cables_[i].cable = std::move(cable);
  }
}

bool InverseIteration::linearise(Steps steps) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    if (!cables_[i].linearise(robot_.cables[i], pose_, steps)) return false;
  }
  return true;
}

void InverseIteration::distribute() {
  const TensionProblem program = tensionProgram(robot_, pose_, external_, cables_, preferred_, turn_);
  // The limits reached last are mostly those reached again.
  std::optional<TensionDistribution> likely =
      distributeAtLimits(program, distribution_.at_lower, distribution_.at_upper);
  distribution_ = likely ? std::move(*likely) : distributeTensions(program);
}

bool InverseIteration::linearisedAboveFolds(const RungOptions& closed_form, Steps steps) {
  if (!linearise(steps)) return false;
  if (pullBackFromFolds(robot_, closed_form, &cables_) && !linearise(Steps::kNew)) return false;
  distribute();
  for (int k = 0; k < kRoundsOfFolds; ++k) {
    if (!raiseLimitsToFolds(robot_, distribution_.tensions, closed_form, &cables_)) break;
    distribute();
  }
  return true;
}

InverseIteration::Move InverseIteration::plannedMove() const {
  Move move;
  if (turn_.free) move.turn = distribution_.tensions.tail<3>();
  // A heavy turn takes short steps: what counts is the slope that is left.
  move.size = move.turn.norm() * std::max(1.0, turn_.weight * turn_.weight);
  for (std::size_t k = 0; k < cables_.size(); ++k) {
    const InverseCable& c = cables_[k];
    const Eigen::Vector3d change = c.change(distribution_.tensions(static_cast<Eigen::Index>(k)), move.turn);
    move.finite = move.finite && change.allFinite();
    move.damping = std::min(move.damping, c.cable.dampingFor(change));
    move.size = std::max({move.size, c.size(change), c.cable.angleChange(change)});
  }
  return move;
}

void InverseIteration::take(const Move& move) {
  for (std::size_t k = 0; k < cables_.size(); ++k) {
    InverseCable& c = cables_[k];
    c.cable.step(c.change(distribution_.tensions(static_cast<Eigen::Index>(k)), move.turn), move.damping);
  }
  pose_ = displaced(pose_, Eigen::Vector3d::Zero(), move.damping * move.turn);
}

void InverseIteration::makeTurnHeavier() { turn_.weight *= kHeavierTurn; }

bool InverseIteration::isBalanced() const { return distribution_.imbalance <= kBalance * robot_.weight(); }

Status InverseIteration::infeasible() const {
  return isFeasible() ? unbalanced() : contradiction(robot_, cables_, distribution_);
}

Status InverseIteration::unbalanced() const {
  std::ostringstream text;
  text << "the " << cables_.size()
       << " cables cannot balance the load at this pose, whatever their tensions: " << distribution_.imbalance
       << " N is left (moments divided by the platform's radius)";
  if (!turn_.free && robot_.type == PlatformType::kRigidBody) {
    text << "; with free_orientation the attitude is left to equilibrium";
  }
  return {Code::kInfeasible, text.str()};
}

Residuals InverseIteration::residuals() const {
  Residuals residuals;
  Wrench total = loadWrench(robot_, pose_, external_);
  for (const InverseCable& c : cables_) {
    total += wrenchAt(c.plane.arm, c.force());
    residuals.closure = std::max(residuals.closure, c.open);
  }
  if (!total.allFinite() || !std::isfinite(residuals.closure)) return {};
  residuals.force = total.head<3>().norm();
  residuals.moment = robot_.type == PlatformType::kPointMass ? 0.0 : total.tail<3>().norm();
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
