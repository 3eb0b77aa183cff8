#include "cable/cable_checks.h"

#include <cmath>
#include <sstream>

#include "cable/text.h"

namespace cdpr_kinetostatics {
namespace {

const Status kFine{Code::kConverged, ""};

std::string withUnit(double value, const char* unit) { return *unit == '\0' ? text(value) : text(value, " ", unit); }

}  // namespace

std::string Field::text() const {
  std::string name = std::string(name_).append(member_);
  if (cable_ != nullptr) name += "[" + std::to_string(index_) + "] of cable '" + *cable_ + "'";
  return name;
}

std::string named(const char* name, double value, const char* unit) {
  std::ostringstream text;
  text.precision(9);
  text << name << " = " << value;
  if (*unit != '\0') text << " " << unit;
  return text.str();
}

Status refused(const Field& field, const std::string& is, const std::string& expected) {
  return {Code::kInvalidInput, field.text() + " is " + is + ": expected " + expected};
}

Status checkWithin(const Field& field, double value, double limit, const char* unit) {
  if (std::abs(value) <= limit) return kFine;
  return refused(field, withUnit(value, unit), "a finite number of magnitude up to " + withUnit(limit, unit));
}

Status checkNotNegative(const Field& field, double value, double limit, const char* unit) {
  if (value >= 0.0 && value <= limit) return kFine;
  return refused(field, withUnit(value, unit), "0 to " + withUnit(limit, unit));
}

Status checkPositive(const Field& field, double value, double limit, const char* unit) {
  if (value > 0.0 && value <= limit) return kFine;
  return refused(field, withUnit(value, unit), "a positive number up to " + withUnit(limit, unit));
}

Status checkModel(Model model) {
  if (isStraight(model) || isCatenary(model) || isBending(model) || model == Model::kAuto) return kFine;
  return refused("model", text(static_cast<int>(model)),
                 "auto, straight, straight_elastic, catenary_inextensible, catenary, catenary_corrected, "
                 "bending_inextensible or bending, which are 1 to 8");
}

Status checkAccuracy(const Field& field, double accuracy) {
  return checkPositive(field, accuracy, kLargestLength, "m");
}

Status checkTolerance(const Field& field, double tolerance) {
  if (tolerance >= kFinestTolerance && tolerance <= kCoarsestTolerance) return kFine;
  return refused(field, text(tolerance), text(kFinestTolerance, " to ", kCoarsestTolerance));
}

Status checkProfilePoints(const Field& field, int points, int most) {
  if (points == 0 || (points >= 2 && points <= most)) return kFine;
  return refused(field, text(points), text("0 (no profile) or 2 to ", most));
}

Status checkOptions(const CableSolverOptions& options) {
  return firstRefusal(checkTolerance("tolerance", options.tolerance),
                      checkProfilePoints("profile_points", options.profile_points),
                      checkAccuracy("accuracy", options.accuracy), checkModel(options.model));
}

Status checkAxialStiffness(double axial_stiffness, Model model) {
  if (isInextensible(model) || axial_stiffness > 0.0) return kFine;
  return refused("axial_stiffness", withUnit(axial_stiffness, "N"),
                 text("a positive number, as the model ", modelName(model),
                      " stretches the cable; an inextensible model needs none"));
}

Status checkCable(const CableProperties& cable, Model model) {
  const Status status = firstRefusal(checkAxialStiffness(cable.axial_stiffness, model),
                                     checkNotNegative("weight", cable.weight, kLargestForce, "N/m"));
  if (!status.ok() || (cable.bending_stiffness >= 0.0 && std::isfinite(cable.bending_stiffness))) return status;
  return refused("bending_stiffness", withUnit(cable.bending_stiffness, "N m^2"), "0 or a positive finite number");
}

Status checkLength(double length) { return checkPositive("length", length, kLargestLength, "m"); }

Status checkEnd(double x, double y) {
  Status status = firstRefusal(checkNotNegative("x", x, kLargestLength, "m"), checkWithin("y", y, kLargestLength, "m"));
  if (x < 0.0) status.message += "; x points from A towards B in the cable's plane";
  return status;
}

Status checkEndsApart(double x, double y) {
  if (x != 0.0 || y != 0.0) return kFine;
  return {Code::kInvalidInput, "x and y are both 0 m: expected the ends of the cable apart, for a length to span"};
}

Status checkForce(const Field& field, double force) { return checkWithin(field, force, kLargestForce, "N"); }

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
