#include "cable/length_search.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {
namespace {

// Bounds of the time. The curve is followed in growing steps, of which a few dozen span it; a bracket is halved at
// least every other time, which exhausts a double's digits; Newton's method from a good hint doubles its digits in each
// step.
constexpr int kMaxSamples = 400;
constexpr int kMaxRefinements = 100;
constexpr int kMaxHintSteps = 8;

// A root that is this near to the hint [share of it] is the hint itself but for rounding on the way here.
constexpr double kAtHint = 1e-9;

// Growth of |L/chord - 1| from one sample of the curve to the next.
constexpr double kGrowth = 0.2;

// An inextensible cable whose sag is below this share of its chord is a string.
constexpr double kStringSag = 1e-12;

// A hint that is longer than the chord by more than this share means a length other than the chord.
constexpr double kLonger = 1e-9;

// Without weight nothing limits a length: it is looked for up to so many chords. With weight, a loop hangs with T_A or
// more from either end, beside twice the chord; its length is searched with a margin of a fifth.
constexpr double kMostChords = 4.0;
constexpr double kMargin = 1.2;

// Root of value(sample), which changes sign between a and b: Newton's method kept inside the bracket.
// value_slope returns the function and its derivative with respect to length (0 if unknown: bisect).
template <typename Value>
std::optional<TensionSample> refine(const TensionCurve& curve, TensionSample a, TensionSample b, double tolerance,
                                    const Value& value) {
  TensionSample best = a;
  for (int i = 0; i < kMaxRefinements; ++i) {
    const auto [f, df] = value(best);
    double next = best.length - f / df;
    if (!(next > std::min(a.length, b.length) && next < std::max(a.length, b.length))) {
      next = 0.5 * (a.length + b.length);
    }
    if (std::abs(next - best.length) <= 4e-16 * next || std::abs(b.length - a.length) <= 4e-16 * next) return best;
    const std::optional<TensionSample> sample = curve(next);
    if (!sample) return std::nullopt;
    best = *sample;
    const double here = value(best).first;
    if (std::abs(here) <= tolerance) return best;
    if ((here > 0.0) == (value(a).first > 0.0)) {
      a = best;
    } else {
      b = best;
    }
  }
  return best;
}

// Tensions that differ by less are the same [N].
double accepted(const LengthSearch& search) { return 0.01 * search.tolerance * search.tension; }

// Whether no root is shorter than the first sample, or one is known already.
bool startsTaut(const TensionSample& first, const LengthSearch& search) {
  return search.near_hint || first.tension >= search.tension - accepted(search);
}

}  // namespace

bool isString(const CableProperties& cable, double x, double y, double tension_a, double length_hint) {
  if (std::isfinite(cable.axial_stiffness)) return false;
  const double chord = std::hypot(x, y);
  const double sag = std::pow(cable.weight * x / tension_a, 2) / 24.0;
  const double hanging = x == 0.0 && y < 0.0 ? cable.weight * chord : 0.0;
  return sag <= kStringSag && tension_a >= hanging && length_hint <= (1.0 + kLonger) * chord;
}

double longestSagging(double weight, double chord, double tension_a) {
  if (weight == 0.0) return kMostChords * chord;
  return 2.0 * chord + kMargin * (2.0 * tension_a / weight + chord);
}

std::optional<double> rootNearHint(const TensionCurve& curve, const LengthSearch& search) {
  double length = search.hint;
  for (int i = 0; i < kMaxHintSteps; ++i) {
    const std::optional<TensionSample> sample = curve(length);
    if (!sample || sample->slope == 0.0) return std::nullopt;
    const double excess = sample->tension - search.tension;
    if (std::abs(excess) <= accepted(search)) return length;
    length -= excess / sample->slope;
    if (!(length > search.shortest && length < search.longest)) return std::nullopt;
  }
  return std::nullopt;
}

bool isAtHint(double length, const LengthSearch& search) {
  return std::abs(length - search.hint) <= kAtHint * search.hint;
}

LengthFound searchLength(const TensionCurve& curve, LengthSearch search) {
  LengthFound found;
  const double same = accepted(search);
  double finest = 1e-6 * search.chord;
  if (search.near_hint) {  // leaves only its mirror image about the hint to be searched
    found.length = search.near_hint;
    const double reach = std::abs(*found.length - search.hint);
    search.shortest = std::max(search.shortest, search.hint - reach * (1.0 + 1e-9));
    search.longest = std::min(search.longest, search.hint + reach);
    finest = std::max(finest, 0.25 * reach);
  }
  std::optional<TensionSample> sample = curve(search.shortest);
  if (!sample || !startsTaut(*sample, search)) return {std::nullopt, 0.0, false};
  found.least_tension = sample->tension;

  const auto excess = [&](const TensionSample& s) { return std::pair{s.tension - search.tension, s.slope}; };
  const auto slope = [&](const TensionSample& s) { return std::pair{s.slope, 0.0}; };
  const auto offer = [&](double length) {
    const bool nearer = !found.length || std::abs(length - search.hint) < std::abs(*found.length - search.hint);
    if (nearer) found.length = length;
  };
  const auto settled = [&](double reached) {
    return found.length && (search.hint <= 0.0 || reached - search.hint > std::abs(*found.length - search.hint));
  };
  for (int i = 0; i < kMaxSamples && sample->length < search.longest && !settled(sample->length); ++i) {
    const TensionSample last = *sample;
    const double above = last.tension - search.tension;
    double step = std::max(kGrowth * std::abs(last.length - search.chord), finest);
    // Where the curve falls towards the tension asked for, its tangent undershoots (the curve is convex).
    if (above > 0.0 && last.slope < 0.0) step = std::max(std::min(step, -above / last.slope), 1e-3 * step);
    sample = curve(std::min(last.length + step, search.longest));
    if (!sample) {
      found.complete = false;
      return found;
    }
    found.least_tension = std::min(found.least_tension, sample->tension);
    if (std::abs(sample->tension - search.tension) <= same) {
      offer(sample->length);
      finest = std::max(finest, kGrowth * std::abs(sample->length - search.chord));
      sample = curve(std::min(sample->length + 0.01 * finest, search.longest));
      if (!sample) return found;
      continue;
    }
    std::optional<TensionSample> root;
    if ((above > 0.0) != (sample->tension > search.tension)) {
      root = refine(curve, last, *sample, same, excess);
      if (!root && !found.length) return {std::nullopt, found.least_tension, false};  // passed, but not reached
    } else if (above > 0.0 && last.slope < 0.0 && sample->slope > 0.0) {
      const std::optional<TensionSample> fold = refine(curve, last, *sample, 0.0, slope);
      if (!fold) continue;
      found.least_tension = std::min(found.least_tension, fold->tension);
      if (fold->tension > search.tension) continue;
      root = refine(curve, last, *fold, same, excess);
      if (root) offer(root->length);
      root = refine(curve, *fold, *sample, same, excess);
    }
    if (root) offer(root->length);
  }
  return found;
}

}  // namespace cdpr_kinetostatics
