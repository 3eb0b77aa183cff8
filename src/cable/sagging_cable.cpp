#include "cable/sagging_cable.h"

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "cable/rope_on_pulley.h"

namespace cdpr_kinetostatics {

CableProperties asSeenBy(Model model, const CableProperties& cable) {
  CableProperties seen = cable;
  if (isInextensible(model)) seen.axial_stiffness = std::numeric_limits<double>::infinity();
  if (!isBending(model) && model != Model::kCatenaryCorrected) seen.bending_stiffness = 0.0;
  if (std::isinf(seen.axial_stiffness)) seen.dead_length = 0.0;  // it gives nothing
  return seen;
}

SaggingCable::Kind SaggingCable::kindOf(const CableProperties& seen, Model model, double tolerance) {
  const bool eyelet = beginsAtEyelet(seen);
  if (isStraight(model)) {
    if (!eyelet) return PulleyCable(seen, FreeShape::kStraight);
    return StraightCable(seen);
  }
  if (seen.bending_stiffness == 0.0) {
    if (!eyelet) return PulleyCable(seen, FreeShape::kCatenary);
    return CatenaryCable(seen);
  }
  if (isBending(model)) return BendingCable(seen, tolerance);
  if (!eyelet) return PulleyCable(seen, FreeShape::kCorrected);
  return CorrectedCatenaryCable(seen);
}

SaggingCable::SaggingCable(const CableProperties& cable, Model model, double tolerance)
    : model_(model), kind_(kindOf(asSeenBy(model, cable), model, tolerance)) {}

void SaggingCable::start(double length, const ForcesAtA& forces) {
  std::visit([&](auto& kind) { return kind.start(length, forces); }, kind_);
}

SolveOutcome SaggingCable::startUnder(double length, const ForcesAtA& forces, const SolveLimits& limits) {
  return std::visit([&](auto& kind) { return kind.startUnder(length, forces, limits); }, kind_);
}

SolveOutcome SaggingCable::startBetween(double length, double x, double y, const SolveLimits& limits) {
  return std::visit([&](auto& kind) { return kind.startBetween(length, x, y, limits); }, kind_);
}

SolveOutcome SaggingCable::followBetween(double length, double x, double y, const SolveLimits& limits) {
  return std::visit([&](auto& kind) { return kind.followBetween(length, x, y, limits); }, kind_);
}

bool SaggingCable::lengthIsChord(double x, double y, double tension_a, double length_hint) const {
  return std::visit([&](const auto& kind) { return kind.lengthIsChord(x, y, tension_a, length_hint); }, kind_);
}

double SaggingCable::longestLength(double chord, double tension_a) const {
  return std::visit([&](const auto& kind) { return kind.longestLength(chord, tension_a); }, kind_);
}

bool SaggingCable::linearise(bool adapt, SolveLimits::Clock::time_point deadline) {
  return std::visit(
      [&](auto& kind) {
        if constexpr (std::is_same_v<decltype(kind), BendingCable&>) {
          return kind.linearise(adapt, deadline);
        } else {
          return kind.linearise(adapt);  // takes microseconds
        }
      },
      kind_);
}

const EndPoint& SaggingCable::end() const {
  return std::visit([&](const auto& kind) -> const EndPoint& { return kind.end(); }, kind_);
}

double SaggingCable::dampingFor(const Eigen::Vector3d& change) const {
  return std::visit([&](const auto& kind) { return kind.dampingFor(change); }, kind_);
}

double SaggingCable::angleChange(const Eigen::Vector3d& change) const {
  return std::visit([&](const auto& kind) { return kind.angleChange(change); }, kind_);
}

void SaggingCable::step(const Eigen::Vector3d& change, double damping) {
  std::visit([&](auto& kind) { return kind.step(change, damping); }, kind_);
}

void SaggingCable::follow(const Eigen::Vector3d& change) {
  std::visit([&](auto& kind) { return kind.follow(change); }, kind_);
}

bool SaggingCable::stepsFit() {
  return std::visit([&](auto& kind) { return kind.stepsFit(); }, kind_);
}

bool SaggingCable::onBranch() const {
  return std::visit([&](const auto& kind) { return kind.onBranch(); }, kind_);
}

ForcesAtA SaggingCable::forces() const {
  return std::visit([&](const auto& kind) { return kind.forces(); }, kind_);
}

double SaggingCable::length() const {
  return std::visit([&](const auto& kind) { return kind.length(); }, kind_);
}

double SaggingCable::freeLength() const {
  return std::visit([](const auto& kind) { return kind.freeLength(); }, kind_);
}

double SaggingCable::verticalForceB() const { return verticalForceA() - properties().weight * freeLength(); }

Eigen::RowVector3d SaggingCable::verticalForceBDerivative() const {
  return std::visit(
      [&](const auto& kind) -> Eigen::RowVector3d {
        return Eigen::RowVector3d::UnitY() - properties().weight * kind.freeLengthDerivative();
      },
      kind_);
}

const CableProperties& SaggingCable::properties() const {
  return std::visit([&](const auto& kind) -> const CableProperties& { return kind.properties(); }, kind_);
}

IntegrationWork SaggingCable::work() const {
  return std::visit([&](const auto& kind) { return kind.work(); }, kind_);
}

bool SaggingCable::startsFromCatenary() const {
  return std::visit([](const auto& kind) { return kind.kStartsFromCatenary; }, kind_);
}

CableSolution SaggingCable::describe(double x, double y, int profile_points) const {
  CableSolution solution = std::visit([&](const auto& kind) { return kind.describe(x, y, profile_points); }, kind_);
  solution.model = model_;
  return solution;
}

}  // namespace cdpr_kinetostatics
