#include "cable/catenary_cable.h"

#include <algorithm>
#include <cmath>

#include "cable/cable_checks.h"
#include "cable/cable_description.h"
#include "cable/catenary.h"

namespace cdpr_kinetostatics {
namespace {

// A itself is not asked of the formula, which needs a length.
Eigen::Vector2d positionAt(const CableProperties& cable, const ForcesAtA& forces, double s) {
  if (!(s > 0.0)) return Eigen::Vector2d::Zero();
  return catenaryEnd(cable, forces.horizontal, forces.vertical, s).position;
}

}  // namespace

ProfilePoint catenaryPoint(const CableProperties& cable, const ForcesAtA& forces, double s) {
  const double h = forces.horizontal;
  const double v = forces.vertical;
  const Eigen::Vector2d at = positionAt(cable, forces, s);
  return {s, at.x(), at.y(), catenaryAngle(cable, h, v, s), 0.0, std::hypot(h, v - cable.weight * s), 0.0};
}

Status catenaryRefusal(const CableProperties& cable, const ForcesAtA& forces) {
  if (pushes(forces)) return carriesNoCompression(forces.horizontal);
  if (forces.horizontal == 0.0 && forces.vertical == 0.0 && cable.weight == 0.0) {
    return {Code::kInvalidInput, "a weightless cable without forces has no defined shape"};
  }
  return {Code::kConverged, ""};
}

SolveOutcome CatenaryCable::startUnder(double length, const ForcesAtA& forces, const SolveLimits& /*limits*/) {
  const Status refusal = catenaryRefusal(properties(), forces);
  if (!refusal.ok()) return {refusal};
  start(length, forces);
  linearise(false);
  if (!end().position.allFinite()) return {{Code::kNotConverged, "the catenary has no end under these forces"}};
  return evaluated();
}

SolveOutcome CatenaryCable::startBetween(double length, double x, double y, const SolveLimits& /*limits*/) {
  ForcesAtA forces;
  const SolveOutcome outcome = solveCatenaryForces(properties(), length, x, y, &forces);
  start(length, forces);
  if (outcome.ok()) linearise(false);
  return outcome;
}

bool CatenaryCable::linearise(bool /*adapt*/) {
  return setEnd(catenaryEnd(properties(), forces().horizontal, forces().vertical, length()));
}

CableSolution catenaryMeasures(const ClosedFormCable& at, const EndPoint& end) {
  const CableProperties& cable = at.properties();
  const double h = at.forces().horizontal;
  const double v = at.forces().vertical;
  const double length = at.length();
  CableSolution solution = solutionUnder(cable, length, at.forces());
  solution.x = end.position.x();
  solution.y = end.position.y();
  solution.end_jacobian = end.jacobian;
  solution.force_jacobian = forceJacobian(end);
  zeroNonFinite(&solution.end_jacobian);
  solution.strained_length = catenaryStrainedLength(cable, h, v, length);
  solution.angle_a = catenaryAngle(cable, h, v, 0.0);
  solution.angle_b = catenaryAngle(cable, h, v, length);
  const double chord = std::hypot(solution.x, solution.y);
  if (cable.weight > 0.0 && h > 0.0 && chord > 0.0) {  // farthest from the chord where parallel to it
    const double s = std::clamp((v + h * solution.y / solution.x) / cable.weight, 0.0, length);
    const Eigen::Vector2d lowest = positionAt(cable, at.forces(), s);
    solution.sag = std::abs(lowest.x() * solution.y - lowest.y() * solution.x) / chord;
  }
  return solution;
}

CableSolution CatenaryCable::describe(double x, double y, int profile_points) const {
  const CableProperties& cable = properties();
  const EndPoint end = catenaryEnd(cable, forces().horizontal, forces().vertical, length());
  CableSolution solution = catenaryMeasures(*this, end);
  solution.closure_residual = std::hypot(solution.x - x, solution.y - y);
  for (int i = 0; i < profile_points; ++i) {
    solution.profile.push_back(catenaryPoint(cable, forces(), length() * i / (profile_points - 1)));
  }
  return solution;
}

}  // namespace cdpr_kinetostatics
