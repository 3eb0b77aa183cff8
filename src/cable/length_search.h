// Problem 3 for every model: lengths at which the tension at A has a given value.
//
// The tension of a cable between two fixed ends falls from infinity as the cable gets longer, reaches a
// least value, and rises again as the cable's own weight takes over; with bending it may fall and rise
// twice (docs/theory.md section 1). So the curve T_A(L) is followed from its taut side: Newton's method
// where the curve falls towards the tension asked for, growing steps elsewhere, bisection in between.
#pragma once

#include <functional>
#include <optional>

#include "cdpr_kinetostatics/cable/cable_properties.h"

namespace cdpr_kinetostatics {

// An inextensible cable stretched like a string: its sag is below rounding, so its length is its chord, and its forces
// do not follow from its length. A hint that is longer asks for another length. Needs x >= 0 and tension_a > 0.
bool isString(const CableProperties& cable, double x, double y, double tension_a, double length_hint);

// No cable that sags is longer than this with this tension at A: its own weight would pull harder [m].
double longestSagging(double weight, double chord, double tension_a);

struct TensionSample {
  double length = 0.0;   // [m]
  double tension = 0.0;  // T_A [N]
  double slope = 0.0;    // dT_A/dL [N/m]
};

// Problem 2 at a length; empty if it could not be solved there (the search then ends).
using TensionCurve = std::function<std::optional<TensionSample>(double length)>;

struct LengthSearch {
  double tension = 0.0;             // asked for [N]
  double chord = 0.0;               // [m]
  double shortest = 0.0;            // search from here: T_A must be above the tension asked for [m]
  double longest = 0.0;             // to here [m]
  double hint = 0.0;                // the root nearest to it is wanted, if positive; else the shortest
  std::optional<double> near_hint;  // a root known already
  double tolerance = 1e-9;          // relative, of the tension
};

struct LengthFound {
  std::optional<double> length;
  double least_tension = 0.0;  // least T_A seen [N]
  bool complete = true;        // false: the curve could not be followed to the end
};

// A root near the hint by Newton's method alone, if that leads to one.
std::optional<double> rootNearHint(const TensionCurve& curve, const LengthSearch& search);

// A root this near to the hint has no other one nearer.
bool isAtHint(double length, const LengthSearch& search);

LengthFound searchLength(const TensionCurve& curve, LengthSearch search);

}  // namespace cdpr_kinetostatics
