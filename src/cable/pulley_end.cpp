#include "cable/pulley_end.h"

#include <cmath>
#include <limits>

#include "cable/catenary.h"
#include "cable/corrected_catenary_cable.h"
#include "cable/pulley_layer.h"
#include "cable/rope_on_pulley.h"
#include "cable/straight_cable.h"

namespace cdpr_kinetostatics {
namespace {

// Newton's method for the free length, which moves the direction of a line by its weight: two or three steps to
// rounding.
constexpr int kMostSteps = 20;
constexpr double kRounding = 1e-15;

// The slope of the free part where it begins, and its derivatives.
struct Direction {
  double angle, by_h, by_v, by_free_length;
};

Direction directionOf(const CableProperties& cable, FreeShape shape, const ForcesAtA& forces, const PulleyLayer& layer,
                      double free_length) {
  const double lumped = shape == FreeShape::kStraight ? 0.5 * cable.weight : 0.0;
  const double u = lumped * free_length - forces.vertical;
  const double square = forces.horizontal * forces.horizontal + u * u;
  const double by_u = forces.horizontal / square;
  return {std::atan2(u, forces.horizontal) + layer.turn, -u / square + layer.turn_by.x(), -by_u + layer.turn_by.y(),
          lumped * by_u};
}

}  // namespace

EndPoint freeEnd(const CableProperties& cable, FreeShape shape, const ForcesAtA& forces, double free_length) {
  const double h = forces.horizontal;
  const double v = forces.vertical;
  switch (shape) {
    case FreeShape::kStraight:
      return straightEnd(cable, h, v, free_length);
    case FreeShape::kCorrected:
      return correctedCatenaryEnd(cable, h, v, free_length);
    case FreeShape::kCatenary:
      break;
  }
  return catenaryEnd(cable, h, v, free_length);
}

PulleyEnd pulleyEnd(const CableProperties& cable, FreeShape shape, const ForcesAtA& forces, double length) {
  PulleyEnd at;
  at.free_length = length;
  const PulleyLayer layer = shape == FreeShape::kCorrected ? pulleyLayer(cable, forces) : PulleyLayer{};
  Direction direction{};
  HeldRope held;
  double slope = 1.0;
  for (int i = 0; i < kMostSteps; ++i) {
    direction = directionOf(cable, shape, forces, layer, at.free_length);
    held = heldRope(cable, forces, direction.angle);
    slope = 1.0 + held.by_angle * direction.by_free_length;
    const double step = (length - held.length - at.free_length) / slope;
    at.free_length += step;
    if (!(std::abs(step) > kRounding * length)) break;
  }
  if (!(at.free_length > 0.0)) {
    at.end.position.setConstant(std::numeric_limits<double>::quiet_NaN());
    return at;
  }
  at.angle = direction.angle;
  at.free_length_by << -held.by_forces.x() - held.by_angle * direction.by_h,
      -held.by_forces.y() - held.by_angle * direction.by_v, 1.0;
  at.free_length_by /= slope;
  at.angle_by = direction.by_free_length * at.free_length_by;
  at.angle_by.head<2>() += Eigen::RowVector2d(direction.by_h, direction.by_v);

  const EndPoint free = freeEnd(cable, shape, forces, at.free_length);
  at.end.position = departurePoint(cable.pulley, at.angle) + free.position + layer.shift;
  at.end.jacobian =
      departureDerivative(cable.pulley, at.angle) * at.angle_by + free.jacobian.col(2) * at.free_length_by;
  at.end.jacobian.leftCols<2>() += free.jacobian.leftCols<2>() + layer.shift_by;
  return at;
}

}  // namespace cdpr_kinetostatics
