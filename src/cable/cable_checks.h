// What a cable problem must satisfy before it is solved; every refusal is a sentence.
#pragma once

#include <string>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/cable/report.h"

namespace cdpr_kinetostatics {

// "name = value": for messages.
std::string named(const char* name, double value, const char* unit);

Status checkAccuracy(double accuracy);

Status checkOptions(const CableSolverOptions& options);
Status checkCable(const CableProperties& cable, Model model);
Status checkLength(double length);
Status checkEnd(double x, double y);
Status checkForce(const char* name, double force);

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
