#include "robot/chord_law.h"

#include <cmath>

#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

// Turned by a quarter to the left.
Eigen::Vector2d quarter(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

ChordLaw::ChordLaw(const SaggingCable& cable, const CablePlane& plane, const Eigen::Matrix2d& stiffness,
                   const Eigen::Vector2d& by_length, double new_length) {
  const double q = cable.properties().weight;
  weight_ = q * (new_length - (cable.length() - cable.freeLength()));
  departure_ = departureUnder(cable.properties(), cable.forces());
  chord_ = std::hypot(plane.x - departure_.x(), plane.y - departure_.y());
  along_ = (Eigen::Vector2d(plane.x, plane.y) - departure_) / chord_;
  const Eigen::Vector2d force(cable.horizontalForce(), 0.5 * q * cable.freeLength() - cable.verticalForceA());
  const Eigen::Vector2d signs(1.0, -1.0);  // f falls as V grows
  by_chord_ = signs.asDiagonal() * stiffness * along_;
  by_turn_ = chord_ * (signs.asDiagonal() * stiffness * quarter(along_)) - quarter(force);
  force_ = force + (new_length - cable.length()) * (signs.cwiseProduct(by_length) + Eigen::Vector2d(0.0, 0.5 * q));
}

ChordLaw::Value ChordLaw::at(const CablePlane& plane) const {
  const double chord = std::hypot(plane.x - departure_.x(), plane.y - departure_.y());
  const Eigen::Vector2d along = (Eigen::Vector2d(plane.x, plane.y) - departure_) / chord;
  Eigen::Matrix2d turn;
  turn.col(0) << along.dot(along_), along_.x() * along.y() - along_.y() * along.x();
  turn.col(1) = quarter(turn.col(0));
  const double angle = std::asin(turn(1, 0));
  const Eigen::Vector2d force = turn * (force_ + (chord - chord_) * by_chord_ + angle * by_turn_);
  const Eigen::Vector2d by_turn = turn * by_turn_ + quarter(force);
  Value value;
  value.stiffness = turn * by_chord_ * along.transpose() + by_turn / chord * quarter(along).transpose();
  value.stiffness.row(1) *= -1.0;
  value.forces << force.x(), 0.5 * weight_ - force.y();
  return value;
}

Eigen::Vector3d ChordLaw::forceOnPlatform(const CablePlane& plane, const Value& value) const {
  return cdpr_kinetostatics::forceOnPlatform(plane, value.forces.x(), value.forces.y(), weight_);
}

}  // namespace cdpr_kinetostatics
