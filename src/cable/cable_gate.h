// The gate that every answer of a cable passes before it is called CONVERGED (docs/theory.md section 3, "The gate").
//
// Iterations stop because their steps have become small. That is no proof: this is.
#pragma once

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/cable/cable_solution.h"
#include "cdpr_kinetostatics/cable/report.h"

namespace cdpr_kinetostatics {

// The largest distance of a computed end from the one asked for that is an answer [m]: the tolerance's share of the
// cable, and what rounding of its forces does to its end.
double acceptedClosure(const CableSolution& solution, double tolerance);

// Whether the solution, which is the description of the cable, is an answer: all of its numbers are finite, its end,
// summed anew from the final forces, and its moments are what they should be to the tolerance, and it is stable and on
// its branch. Otherwise the code and the sentence that it deserves. Whatever its own status says is not looked at.
Status verdictOf(const SaggingCable& cable, const CableSolution& solution, double tolerance);

// Whether the rope lies on its guide pulley. The weight that a straight line lumps where it leaves says nothing of
// that.
Status contactOf(const CableProperties& properties, const CableSolution& cable);

}  // namespace cdpr_kinetostatics
