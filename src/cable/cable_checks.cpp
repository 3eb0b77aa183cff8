#include "cable/cable_checks.h"

#include <cmath>
#include <sstream>

#include "cable/input_limits.h"

namespace cdpr_kinetostatics {
namespace {

Status invalid(const std::string& message) { return {Code::kInvalidInput, message}; }
const Status kFine{Code::kConverged, ""};

}  // namespace

std::string named(const char* name, double value, const char* unit) {
  std::ostringstream text;
  text.precision(9);
  text << name << " = " << value;
  if (*unit != '\0') text << " " << unit;
  return text.str();
}

Status checkModel(Model model) {
  if (isStraight(model) || isCatenary(model) || isBending(model) || model == Model::kAuto) return kFine;
  return invalid(
      "the model is none of auto, straight, straight_elastic, catenary_inextensible, catenary, "
      "catenary_corrected, bending_inextensible and bending");
}

Status checkAccuracy(double accuracy) {
  if (accuracy > 0.0 && accuracy <= kLargestLength) return kFine;
  return invalid(named("accuracy", accuracy, "m") + " must be positive and at most 1e6 m");
}

Status checkOptions(const CableSolverOptions& options) {
  if (!(options.tolerance >= kFinestTolerance && options.tolerance <= kCoarsestTolerance)) {
    return invalid(named("tolerance", options.tolerance, "") + " must lie between 1e-13 and 0.1");
  }
  if (options.profile_points < 0 || options.profile_points == 1 || options.profile_points > kMostProfilePoints) {
    return invalid(named("profile_points", options.profile_points, "") + " must be 0, or between 2 and 100000");
  }
  return firstRefusal(checkAccuracy(options.accuracy), checkModel(options.model));
}

Status checkCable(const CableProperties& cable, Model model) {
  if (!isInextensible(model) && !(cable.axial_stiffness > 0.0)) {
    return invalid(named("axial stiffness", cable.axial_stiffness, "N") + " must be positive");
  }
  if (!(cable.weight >= 0.0 && cable.weight <= kLargestForce)) {
    return invalid(named("weight per metre", cable.weight, "N/m") + " must be zero or positive and finite");
  }
  if (!(cable.bending_stiffness >= 0.0 && std::isfinite(cable.bending_stiffness))) {
    return invalid(named("bending stiffness", cable.bending_stiffness, "N m^2") +
                   " must be zero or positive and finite");
  }
  return kFine;
}

Status checkLength(double length) {
  if (length > 0.0 && length <= kLargestLength) return kFine;
  return invalid(named("length", length, "m") + " must be positive and at most 1e6 m");
}

Status checkEnd(double x, double y) {
  if (!(std::isfinite(x) && std::isfinite(y) && std::hypot(x, y) <= kLargestLength)) {
    return invalid("the end point (" + named("x", x, "m") + ", " + named("y", y, "m") +
                   ") must be finite and within 1e6 m");
  }
  if (x < 0.0) {
    return invalid(named("x", x, "m") + " must not be negative: x points from A towards B in the cable's plane");
  }
  return kFine;
}

Status checkForce(const char* name, double force) {
  if (std::isfinite(force) && std::abs(force) <= kLargestForce) return kFine;
  return invalid(named(name, force, "N") + " must be finite and at most 1e12 N");
}

Status cannotReach(double length, double chord) {
  return {Code::kInfeasible, named("an inextensible cable of length", length, "m") + " cannot reach " +
                                 named("a chord of", chord, "m") + ": lengthen it, or use an elastic model"};
}

Status carriesNoCompression(double horizontal_force) {
  return {Code::kInfeasible, named("horizontal_force", horizontal_force, "N") +
                                 " is compression, which only a cable with bending stiffness can carry: use a bending "
                                 "model"};
}

Status belowLeastTension(double tension_a, double least_tension) {
  return {Code::kInfeasible, named("tension_a", tension_a, "N") + " is below the least tension that can hold this " +
                                 named("cable, T", least_tension, "N") + ": ask for more tension or move the ends"};
}

}  // namespace cdpr_kinetostatics
