// What a cable problem must satisfy before it is solved, and the checks of single numbers that robots, estimates and
// messages share.
//
// Every refusal is INVALID_INPUT with a sentence of one form: "<field> is <value> <unit>: expected <what>". The caller
// says what its user calls the field.
#pragma once

#include <string>
#include <string_view>

#include "cable/input_limits.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/cable/report.h"

namespace cdpr_kinetostatics {

// The name of a field. It is put together only where the field is refused, so that checks that pass need no memory;
// what it is made of must live as long as the check.
class Field {
 public:
  Field(const char* name) : name_(name) {}         // NOLINT(google-explicit-constructor): names are written as texts
  Field(const std::string& name) : name_(name) {}  // NOLINT(google-explicit-constructor)
  // As in "pose" and ".position.x".
  Field(std::string_view owner, std::string_view member) : name_(owner), member_(member) {}
  // The entry of a list that has one for each cable, as in "lengths[3] of cable 'cable3'".
  Field(std::string_view list, std::size_t index, const std::string& cable)
      : name_(list), index_(index), cable_(&cable) {}

  std::string text() const;

 private:
  std::string_view name_, member_;
  std::size_t index_ = 0;
  const std::string* cable_ = nullptr;  // null: no entry of a list
};

// "name = value": for messages.
std::string named(const char* name, double value, const char* unit);

// The refusal of a field; `is` is what it is, in words.
Status refused(const Field& field, const std::string& is, const std::string& expected);

// Finite, and of a magnitude up to the limit.
Status checkWithin(const Field& field, double value, double limit, const char* unit);
Status checkNotNegative(const Field& field, double value, double limit, const char* unit);
Status checkPositive(const Field& field, double value, double limit, const char* unit);
Status checkBetween(const Field& field, double value, double least, double largest, const char* unit);
Status checkZeroOrBetween(const Field& field, double value, double least, double largest, const char* unit);

Status checkAccuracy(const Field& field, double accuracy);
Status checkTolerance(const Field& field, double tolerance);
Status checkProfilePoints(const Field& field, int points, int most = kMostProfilePoints);

Status checkOptions(const CableSolverOptions& options);
Status checkAxialStiffness(double axial_stiffness, Model model);
// Guide pulley and dead length.
Status checkWinchSide(const CableProperties& cable);
Status checkCable(const CableProperties& cable, Model model);
Status checkLength(const Field& field, double length);
Status checkEnd(double x, double y);
// The ends of a cable whose length is asked for.
Status checkEndsApart(double x, double y);
Status checkForce(const Field& field, double force);

// What several kinds of cables refuse: an inextensible one that is too short, compression where nothing can carry it,
// and problem 3 with less tension than it takes to hold the cable.
Status cannotReach(double length, double chord);
Status carriesNoCompression(double horizontal_force);
Status belowLeastTension(double tension_a, double least_tension);

// The first refusal among checks, or CONVERGED.
template <typename... Checks>
Status firstRefusal(const Checks&... checks) {
  Status status{Code::kConverged, ""};
  static_cast<void>(((status = checks, status.ok()) && ...));
  return status;
}

}  // namespace cdpr_kinetostatics
