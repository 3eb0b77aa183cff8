#include "cable/cable_checks.h"

#include <algorithm>
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

Status checkBetween(const Field& field, double value, double least, double largest, const char* unit) {
  if (value >= least && value <= largest) return kFine;
  return refused(field, withUnit(value, unit), withUnit(least, unit) + " to " + withUnit(largest, unit));
}

Status checkZeroOrBetween(const Field& field, double value, double least, double largest, const char* unit) {
  if (value == 0.0 || (value >= least && value <= largest)) return kFine;
  return refused(field, withUnit(value, unit), "0, or " + withUnit(least, unit) + " to " + withUnit(largest, unit));
}

Status checkModel(Model model) {
  if (model == Model::kAuto || std::find(kRungs.begin(), kRungs.end(), model) != kRungs.end()) return kFine;
  return refused(
      "model", text(static_cast<int>(model)),
      text(modelNames(), ", which are ", static_cast<int>(Model::kAuto), " to ", static_cast<int>(kRungs.back())));
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
  const bool infinite = axial_stiffness > 0.0 && std::isinf(axial_stiffness);
  const bool finite = axial_stiffness >= kLeastAxialStiffness && axial_stiffness <= kLargestAxialStiffness;
  if (isInextensible(model) || infinite || finite) return kFine;
  return refused("axial_stiffness", withUnit(axial_stiffness, "N"),
                 text(kLeastAxialStiffness, " N to ", kLargestAxialStiffness, " N, or infinity, as the model ",
                      modelName(model), " stretches the cable; an inextensible model needs none"));
}

Status checkWinchSide(const CableProperties& cable) {
  return firstRefusal(
      checkZeroOrBetween("pulley_radius", cable.pulley.radius, kLeastPulleyRadius, kLargestPulleyRadius, "m"),
      checkNotNegative("dead_length", cable.dead_length, kLargestDeadLength, "m"));
}

Status checkCable(const CableProperties& cable, Model model) {
  return firstRefusal(checkAxialStiffness(cable.axial_stiffness, model),
                      checkZeroOrBetween("weight", cable.weight, kLeastWeight, kLargestForce, "N/m"),
                      checkZeroOrBetween("bending_stiffness", cable.bending_stiffness, kLeastBendingStiffness,
                                         kLargestBendingStiffness, "N m^2"),
                      checkWinchSide(cable));
}

Status checkLength(const Field& field, double length) {
  return checkBetween(field, length, kShortestLength, kLargestLength, "m");
}

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
