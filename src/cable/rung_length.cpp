// Problem 3 of one cable with a given model: follows the tension at A along the length (length_search.h), from the taut
// side.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cable/cable_checks.h"
#include "cable/cable_description.h"
#include "cable/length_search.h"
#include "cable/pulley_cable.h"
#include "cable/rope_on_pulley.h"
#include "cable/rung_problems.h"
#include "cable/sagging_cable.h"
#include "cable/straight_cable.h"
#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

// Problem 3 has found its length if the tension there is the one asked for to this relative accuracy, or to the
// tolerance if that is coarser.
constexpr double kTensionFound = 1e-6;

// The tension of a stiff cable moves with its length's own rounding: this share of EA.
constexpr double kLengthRounding = 1e-14;

// The search starts where the tension is higher than asked for by this share: a little if the catenary's length is
// known, twice as much and the weight of the chord if not. As long as that is not the taut side, the share is made
// larger by this factor, at most so many times: far beyond any tension that a double can tell from others.
constexpr double kMoreThanCatenary = 0.02;
constexpr double kMoreThanLine = 2.0;
constexpr double kGrowingShare = 4.0;
constexpr int kMostGrowths = 20;

// The cable between its two ends at any length, and its tension there. Kept from one length to the next: a cable that
// is expensive to solve is followed.
class CableAtLength {
 public:
  CableAtLength(const CableProperties& properties, double x, double y, const RungOptions& options)
      : cable_(properties, options.model, options.limits.tolerance), options_(options), x_(x), y_(y) {}

  const SaggingCable& cable() const { return cable_; }

  // All that was done so far, and how the last solve ended.
  const SolveOutcome& outcome() const { return outcome_; }

  bool solve(double length) {
    if (options_.limits.haveEnded()) {
      outcome_.status = {Code::kTimedOut, "the time allowed ran out while looking for the length"};
      return false;
    }
    const bool warm = outcome_.ok();
    outcome_.then(warm ? cable_.followBetween(length, x_, y_, options_.limits)
                       : cable_.startBetween(length, x_, y_, options_.limits));
    return outcome_.ok();
  }

  // The slope is that of equation (23). Empty where the cable has no solution.
  std::optional<TensionSample> sample(double length) {
    if (!solve(length)) return std::nullopt;
    const double tension = cable_.tensionA();
    const Eigen::Vector2d by_length = forceJacobian(cable_.end()).col(2);
    const double slope = (cable_.horizontalForce() * by_length.x() + cable_.verticalForceA() * by_length.y()) / tension;
    return TensionSample{length, tension, tension > 0.0 ? slope : 0.0};
  }

  bool pulls() const { return pullsAllAlong(cable_.properties(), cable_.length(), cable_.forces()); }

 private:
  SaggingCable cable_;
  const RungOptions options_;
  const double x_, y_;
  SolveOutcome outcome_;
};

// One request for a length, and what has been done for it.
class LengthProblem {
 public:
  LengthProblem(const CableProperties& properties, double x, double y, double tension_a, double length_hint,
                const RungOptions& options)
      : properties_(properties),
        x_(x),
        y_(y),
        chord_(straightWay(properties, x, y)),
        tension_(tension_a),
        hint_(length_hint),
        options_(options),
        at_hint_(properties, x, y, options),
        along_(properties, x, y, options) {}

  CableSolution solve() {
    if (along_.cable().lengthIsChord(x_, y_, tension_, hint_)) return stretchedLine();
    LengthSearch search;
    search.tension = tension_;
    search.chord = chord_;
    search.hint = hint_;
    search.tolerance = options_.limits.tolerance;
    search.longest = along_.cable().longestLength(chord_, tension_);
    // From the hint's own shape: one followed from far away may be another.
    if (hint_ > 0.0) {
      search.near_hint = rootNearHint([this](double length) { return at_hint_.sample(length); }, search);
      if (search.near_hint && isAtHint(*search.near_hint, search)) return found(*search.near_hint, &at_hint_);
    }
    search.shortest = tautSide();
    const LengthFound lengths = searchLength([this](double length) { return along_.sample(length); }, search);
    if (options_.limits.haveEnded()) {
      return refused({Code::kTimedOut, "the time allowed ran out while looking for the length"});
    }
    if (lengths.length) return found(*lengths.length, lengths.length == search.near_hint ? &at_hint_ : &along_);
    if (lengths.complete) return tooLittleTension(lengths.least_tension);
    return refused({Code::kNotConverged, "the tension could not be followed along the length"});
  }

 private:
  CableSolution stretchedLine() const {
    const CableProperties& cable = along_.cable().properties();
    return beginsAtEyelet(cable) ? stretched(StraightCable(cable))
                                 : stretched(PulleyCable(cable, FreeShape::kStraight));
  }

  template <typename Line>
  CableSolution stretched(Line line) const {
    double least_tension = 0.0;
    const SolveOutcome outcome = line.startWithTension(x_, y_, tension_, &least_tension);
    if (!outcome.ok()) return tooLittleTension(least_tension);
    CableSolution solution = line.describe(x_, y_, options_.profile_points);
    solution.model = options_.model;
    return solution;
  }

  // A length on the taut side of the fold, where the tension is above the one asked for.
  double tautSide() {
    const bool from_catenary = along_.cable().startsFromCatenary();
    double more = from_catenary ? kMoreThanCatenary : kMoreThanLine + properties_.weight * chord_ / tension_;
    double length = chord_;
    for (int i = 0; i < kMostGrowths; ++i, more *= kGrowingShare) {
      const double tension = tension_ * (1.0 + more);
      const std::optional<double> of_catenary = from_catenary ? catenaryLength(tension) : std::nullopt;
      length = of_catenary ? *of_catenary : lineLength(tension);
      const std::optional<TensionSample> sample = along_.sample(length);
      if (!sample) break;
      // In compression the tension falls again beyond the fold: not the taut side.
      if (sample->tension > tension_ && sample->slope < 0.0 && along_.pulls()) break;
    }
    return length;
  }

  // Bending lowers the tension at a given length.
  std::optional<double> catenaryLength(double tension) {
    RungOptions coarser = options_;
    coarser.model = startingRung(options_.model);
    coarser.profile_points = 0;
    const CableSolution catenary = lengthOnRung(properties_, x_, y_, tension, 0.0, coarser);
    before_ += catenary.iterations;
    return catenary.status.ok() ? std::optional(catenary.length) : std::nullopt;
  }

  // A line that stretches, or one with a parabola's sag.
  double lineLength(double tension) const {
    const CableProperties& cable = along_.cable().properties();
    if (std::isfinite(cable.axial_stiffness)) {
      const double strain = tension / cable.axial_stiffness;
      return (chord_ - cable.dead_length * strain) / (1.0 + strain);
    }
    return chord_ * (1.0 + 0.5 * std::pow(cable.weight * x_ / tension, 2) / 24.0);
  }

  CableSolution found(double length, CableAtLength* at) {
    if (!at->solve(length)) {
      return refused({Code::kNotConverged, "the cable could not be solved at the length found"});
    }
    CableSolution solution = verifiedCable(at->cable(), at->outcome(), options_.limits,
                                           at->cable().describe(x_, y_, options_.profile_points));
    if (!solution.status.ok()) return refused(solution.status);
    const double axial_stiffness = at->cable().properties().axial_stiffness;
    const double rounding = std::isfinite(axial_stiffness) ? kLengthRounding * axial_stiffness : 0.0;
    const double accepted = std::max(options_.limits.tolerance, kTensionFound) * tension_;
    if (std::abs(solution.tension_a - tension_) > accepted + rounding) {
      return refused({Code::kNotConverged, "the length found does not give the tension asked for"});
    }
    solution.iterations = iterations();
    return solution;
  }

  int iterations() const { return before_ + at_hint_.outcome().iterations + along_.outcome().iterations; }

  CableSolution refused(const Status& status) const {
    SolveOutcome outcome = along_.outcome();
    outcome.status = status;
    outcome.iterations = iterations();
    IntegrationWork work = at_hint_.cable().work();
    work += along_.cable().work();
    return refusedCable(options_.model, outcome, work);
  }

  CableSolution tooLittleTension(double least_tension) const {
    CableSolution solution = refused(belowLeastTension(tension_, least_tension));
    solution.least_tension = least_tension;
    return solution;
  }

  const CableProperties properties_;
  const double x_, y_, chord_, tension_, hint_;
  const RungOptions options_;
  CableAtLength at_hint_, along_;
  int before_ = 0;  // iterations on the catenary
};

}  // namespace

CableSolution lengthOnRung(const CableProperties& cable, double x, double y, double tension_a, double length_hint,
                           const RungOptions& options) {
  const Status check =
      firstRefusal(checkCable(cable, options.model), checkEnd(x, y), checkEndsApart(x, y),
                   checkReach(cable.pulley, x, y), checkPositive("tension_a", tension_a, kLargestForce, "N"),
                   length_hint <= 0.0 ? Status{Code::kConverged, ""} : checkLength("length_hint", length_hint));
  if (!check.ok()) return refusedCable(options.model, {check});
  return LengthProblem(cable, x, y, tension_a, length_hint, options).solve();
}

}  // namespace cdpr_kinetostatics
