#include "cable/cable_gate.h"

#include <algorithm>
#include <cmath>

#include "cable/cable_checks.h"
#include "cable/rope_on_pulley.h"

namespace cdpr_kinetostatics {
namespace {

// Forces and coordinates are known to this share of themselves, a thousand roundings of a double: a sum over a cable's
// segments has so many.
constexpr double kRounding = 1e-13;

// A node's moment is the last of a Newton iteration's numbers to become small, for it is measured before the last step.
constexpr double kMomentShare = 10.0;

bool isFinite(const ProfilePoint& point) {
  return std::isfinite(point.s) && std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.alpha) &&
         std::isfinite(point.moment) && std::isfinite(point.tension) && std::isfinite(point.shear);
}

bool isFinite(const CableSolution& s) {
  const double numbers[] = {s.length,
                            s.strained_length,
                            s.x,
                            s.y,
                            s.horizontal_force,
                            s.tension_a,
                            s.tension_b,
                            s.angle_a,
                            s.angle_b,
                            s.free_length,
                            s.wrap_angle,
                            s.vertical_force_a,
                            s.sag,
                            s.max_moment,
                            s.max_shear,
                            s.estimated_error,
                            s.closure_residual,
                            s.moment_residual};
  return std::all_of(std::begin(numbers), std::end(numbers), [](double value) { return std::isfinite(value); }) &&
         s.end_jacobian.allFinite() && s.force_jacobian.allFinite() &&
         std::all_of(s.profile.begin(), s.profile.end(), [](const ProfilePoint& point) { return isFinite(point); });
}

// The largest moment defect that is an answer [N m]. Beside the moments of its forces the cable has those of its
// buckling load, which a bar without any load is measured by.
double acceptedMoment(const SaggingCable& cable, const CableSolution& solution, double tolerance) {
  const double by_force = std::max(solution.tension_a, solution.tension_b) * solution.length;
  const double by_stiffness = M_PI * M_PI * cable.properties().bending_stiffness / solution.length;
  return kMomentShare * std::max(tolerance, kRounding) * (solution.max_moment + by_force + by_stiffness);
}

}  // namespace

double acceptedClosure(const CableSolution& solution, double tolerance) {
  const double size = std::max({solution.length, solution.strained_length, std::hypot(solution.x, solution.y)});
  const double forces = std::max(solution.tension_a, solution.tension_b);
  return std::max(tolerance, kRounding) * size + kRounding * solution.end_jacobian.leftCols<2>().norm() * forces;
}

Status contactOf(const CableProperties& properties, const CableSolution& cable) {
  if (isStraight(cable.model)) return checkWrap(properties.pulley, cable.angle_a);
  return checkContact(properties, {cable.horizontal_force, cable.vertical_force_a}, cable.angle_a);
}

Status verdictOf(const SaggingCable& cable, const CableSolution& solution, double tolerance) {
  if (!isFinite(solution)) {
    return {Code::kNotConverged,
            "the cable's numbers do not fit into a double: it is too soft, too stiff or too light "
            "for its forces"};
  }
  if (!(solution.closure_residual <= acceptedClosure(solution, tolerance))) {
    return {Code::kNotConverged, "the forces found take the end of the cable to another point, " +
                                     named("away by", solution.closure_residual, "m")};
  }
  if (!(solution.moment_residual <= acceptedMoment(cable, solution, tolerance))) {
    return {Code::kNotConverged,
            "the cable's segments do not join: " + named("the moment jumps by", solution.moment_residual, "N m")};
  }
  const Status contact = contactOf(cable.properties(), solution);
  if (!contact.ok()) return contact;
  if (!cable.onBranch()) {
    return {Code::kWrongBranch, "the equilibrium found is not the sagging, stable one"};
  }
  return {Code::kConverged, ""};
}

}  // namespace cdpr_kinetostatics
