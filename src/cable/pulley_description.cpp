#include "cable/pulley_description.h"

#include <algorithm>
#include <cmath>

#include "cable/pulley_layer.h"
#include "cable/rope_on_pulley.h"

namespace cdpr_kinetostatics {
namespace {

// Where the sag of a layer is looked for, in its thicknesses: its offset from the chord has a flat maximum, beyond
// which it falls linearly.
constexpr int kLayerSamples = 12;

}  // namespace

void addHeldRope(const CableProperties& cable, double length, CableSolution* solution) {
  const ForcesAtA forces{solution->horizontal_force, solution->vertical_force_a};
  const Eigen::Vector2d departure = departurePoint(cable.pulley, solution->angle_a);
  const HeldRope held = heldRope(cable, forces, solution->angle_a);
  solution->free_length = solution->length;
  solution->length = length;
  solution->closure_residual += std::abs(solution->free_length + held.length - length);
  solution->departure_x = departure.x();
  solution->departure_y = departure.y();
  solution->x += departure.x();
  solution->y += departure.y();
  for (ProfilePoint& point : solution->profile) {
    point.x += departure.x();
    point.y += departure.y();
  }
  if (!hasPulley(cable)) return;
  solution->wrap_angle = wrapAngle(cable.pulley, solution->angle_a);
  solution->strained_length += cable.pulley.radius * solution->wrap_angle;
  solution->max_moment = std::max(solution->max_moment, std::abs(momentAtDeparture(cable)));
}

// The description of the corrected catenary is that of a cable whose moment vanishes where it begins. What is added
// dies out with the layer's thickness; the sag is looked for within it and where the catenary is parallel to the chord.
void addPulleyLayer(const CableProperties& cable, const PulleyEnd& at, CableSolution* solution) {
  const ForcesAtA forces{solution->horizontal_force, solution->vertical_force_a};
  const PulleyLayer layer = pulleyLayer(cable, forces);
  if (layer.thickness == 0.0) return;
  const double moment = momentAtDeparture(cable);
  const auto left = [&](double s) { return std::exp(-s / layer.thickness); };
  for (ProfilePoint& point : solution->profile) {
    const double share = left(point.s);
    point.x += (1.0 - share) * layer.shift.x();
    point.y += (1.0 - share) * layer.shift.y();
    point.alpha += share * (at.angle - solution->angle_a);
    point.moment += share * moment;
    point.shear += share * moment / layer.thickness;
    point.tension *= std::cos(share * layer.turn);
  }
  solution->x += layer.shift.x();
  solution->y += layer.shift.y();
  solution->angle_a = at.angle;
  solution->max_shear = std::max(solution->max_shear, std::abs(moment) / layer.thickness);
  const Eigen::Vector2d chord(solution->x, solution->y);
  const double weight = cable.weight;
  const auto offset = [&](double s) {
    if (!(s > 0.0)) return 0.0;
    const Eigen::Vector2d point =
        freeEnd(cable, FreeShape::kCatenary, forces, s).position + (1.0 - left(s)) * layer.shift;
    return std::abs(point.x() * chord.y() - point.y() * chord.x()) / chord.norm();
  };
  const double parallel = (forces.vertical + forces.horizontal * chord.y() / chord.x()) / weight;
  solution->sag = weight > 0.0 ? offset(std::clamp(parallel, 0.0, at.free_length)) : 0.0;
  for (int i = 1; i <= kLayerSamples; ++i) {
    solution->sag = std::max(solution->sag, offset(std::min(i * layer.thickness, at.free_length)));
  }
}

}  // namespace cdpr_kinetostatics
