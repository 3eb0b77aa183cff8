#include "cable/rung_problems.h"

#include <algorithm>
#include <cmath>

#include "cable/bending.h"
#include "cable/bending_expansion.h"
#include "cable/cable_checks.h"
#include "cable/cable_evaluation.h"
#include "cable/catenary.h"
#include "cable/length_search.h"
#include "cable/straight.h"

namespace cdpr_kinetostatics {
namespace {

// An inextensible cable whose sag is below this share of its chord is a string: its length is the chord.
constexpr double kStringSag = 1e-12;

// Problem 3 has found its length if the tension there is the one asked for to this relative accuracy, or to the
// tolerance if that is coarser.
constexpr double kTensionFound = 1e-6;

CableSolution refusal(Model model, const Status& status) {
  CableSolution solution;
  solution.status = status;
  solution.model = model;
  return solution;
}

bool bends(const CableProperties& cable, Model model) { return isBending(model) && cable.bending_stiffness > 0.0; }

CableSolution bendingSolution(const CableProperties& cable, const RungOptions& options, const BendingOutcome& outcome,
                              const MultipleShooting& shooting) {
  if (!outcome.status.ok()) return refusal(options.model, outcome.status);
  CableSolution solution = describeBending(cable, options.model, shooting, options.profile_points);
  solution.iterations = outcome.iterations;
  return solution;
}

Status noFirstOrder() {
  return {Code::kNotConverged,
          "bending is too large here for its first-order effect to describe it: use a bending model"};
}

// Why a catenary or a line has no forces between these ends.
Status noForces(const CableProperties& cable, double length, double chord) {
  if (std::isinf(cable.axial_stiffness) && length <= chord) {
    return {Code::kInfeasible, named("an inextensible cable of length", length, "m") + " cannot reach " +
                                   named("a chord of", chord, "m") + ": lengthen it, or use an elastic model"};
  }
  if (cable.weight == 0.0 && length >= chord) {
    return {Code::kInfeasible,
            "a slack cable without weight and bending stiffness has no defined shape: give it a linear density"};
  }
  if (cable.bending_stiffness > 0.0) return noFirstOrder();
  return {Code::kNotConverged, "the catenary's forces were not found"};
}

Status straightWithoutForces(double length, double chord, double tolerance) {
  if (std::abs(length - chord) > tolerance * chord) {
    return {Code::kInfeasible, named("an inextensible straight cable of length", length, "m") + " cannot span " +
                                   named("a chord of", chord, "m") + ": use straight_elastic or a catenary"};
  }
  return {Code::kInvalidInput,
          "the tension of an inextensible straight cable does not follow from its geometry: give the tension "
          "(FIND_LENGTH) or use straight_elastic"};
}

// Problem 2, kept warm from one length to the next while problem 3 looks for its root.
class ForcesAlongLength {
 public:
  ForcesAlongLength(const CableProperties& seen, const RungOptions& options, double x, double y)
      : cable_(seen), options_(options), x_(x), y_(y) {}

  const CableProperties& cable() const { return cable_; }

  bool solve(double length) {
    if (bends(cable_, options_.model)) return bend(length);
    length_ = length;
    if (isStraight(options_.model)) {
      forces_ = straightForces(cable_, length, x_, y_);
      return std::hypot(x_, y_) > length;
    }
    const std::optional<ForcesAtA> catenary = correctedCatenaryForces(cable_, length, x_, y_, &iterations_);
    if (catenary) forces_ = *catenary;
    return catenary.has_value();
  }

  std::optional<TensionSample> sample(double length) {
    if (!solve(length)) return std::nullopt;
    const CableSolution at = describe(0);
    const double slope =
        at.tension_a > 0.0
            ? (at.horizontal_force * at.force_jacobian(0, 2) + at.vertical_force_a * at.force_jacobian(1, 2)) /
                  at.tension_a
            : 0.0;
    return TensionSample{length, at.tension_a, slope};
  }

  // Under tension all along.
  bool pulls() const { return !bends(cable_, options_.model) || shooting_.horizontalForce() > 0.0 || x_ == 0.0; }

  CableSolution describe(int profile_points) const {
    if (bends(cable_, options_.model)) {
      CableSolution solution = describeBending(cable_, options_.model, shooting_, profile_points);
      solution.closure_residual = std::hypot(solution.x - x_, solution.y - y_);
      solution.iterations = iterations_;
      return solution;
    }
    CableSolution solution = describeClosedForm(cable_, options_.model, length_, forces_.horizontal, forces_.vertical,
                                                x_, y_, profile_points);
    solution.iterations = iterations_;
    return solution;
  }

 private:
  bool bend(double length) {
    const SolveLimits& limits = options_.limits;
    if (warm_) {
      const BendingOutcome outcome = followBendingForces(length, x_, y_, limits, &shooting_);
      iterations_ += outcome.iterations;
      if (outcome.status.ok()) return true;
    }
    const BendingOutcome outcome = solveBendingForces(cable_, length, x_, y_, limits, &shooting_);
    iterations_ += outcome.iterations;
    warm_ = outcome.status.ok();
    return warm_;
  }

  const CableProperties cable_;
  const RungOptions options_;
  const double x_, y_;
  double length_ = 0.0;
  ForcesAtA forces_;
  MultipleShooting shooting_;
  bool warm_ = false;
  int iterations_ = 0;
};

CableSolution belowLeastTension(Model model, double tension, double least) {
  CableSolution solution = refusal(
      model, {Code::kInfeasible, named("tension_a", tension, "N") + " is below the least tension that can hold this " +
                                     named("cable, T", least, "N") + ": ask for more tension or move the ends"});
  solution.least_tension = least;
  return solution;
}

// The line's own tension from the tension at A, which carries half of the weight q L besides.
CableSolution straightLength(const CableProperties& cable, double x, double y, double tension_a,
                             const RungOptions& options) {
  const double chord = std::hypot(x, y);
  const double half_weight = 0.5 * cable.weight * chord;
  const double middle = half_weight * y / chord;
  const double square = middle * middle + tension_a * tension_a - half_weight * half_weight;
  const double least = middle > 0.0 ? half_weight * x / chord : half_weight;
  if (square < 0.0 || middle + std::sqrt(square) < 0.0) {
    return belowLeastTension(options.model, tension_a, least);
  }
  const double tension = middle + std::sqrt(square);
  return describeClosedForm(cable, options.model, chord, tension * x / chord, half_weight - tension * y / chord, x, y,
                            options.profile_points);
}

// An inextensible cable stretched like a string. Its forces do not follow from its length: they are those
// of the string, which holds half of its weight at either end.
std::optional<CableSolution> stringLength(const CableProperties& cable, double x, double y, double tension_a,
                                          double length_hint, const RungOptions& options) {
  const double chord = std::hypot(x, y);
  const double sag = std::pow(cable.weight * x / tension_a, 2) / 24.0;
  const double hanging = x == 0.0 && y < 0.0 ? cable.weight * chord : 0.0;
  if (sag > kStringSag || tension_a < hanging || length_hint > (1.0 + 1e-9) * chord) return std::nullopt;
  RungOptions straight = options;
  straight.model = Model::kStraight;
  CableSolution solution = x == 0.0 ? describeClosedForm(cable, Model::kStraight, chord, 0.0,
                                                         std::copysign(tension_a, -y), x, y, options.profile_points)
                                    : straightLength(cable, x, y, tension_a, straight);
  solution.model = options.model;
  return solution;
}

// A length on the taut side of the fold, for a tension of about this much: that of the catenary where the
// cable bends (bending lowers the tension at a given length), else of a line with a parabola's sag.
double tautLength(const CableProperties& cable, double x, double y, double tension, const RungOptions& options) {
  const double chord = std::hypot(x, y);
  if (bends(cable, options.model)) {
    RungOptions coarser = options;
    coarser.model = startingRung(options.model);
    coarser.profile_points = 0;
    const CableSolution catenary = lengthOnRung(cable, x, y, tension, 0.0, coarser);
    if (catenary.status.ok()) return catenary.length;
  }
  if (isInextensible(options.model)) return chord * (1.0 + 0.5 * std::pow(cable.weight * x / tension, 2) / 24.0);
  return chord / (1.0 + tension / cable.axial_stiffness);
}

CableSolution atLengthFound(double length, double tension_a, const RungOptions& options, ForcesAlongLength* problem) {
  if (!problem->solve(length)) {
    return refusal(options.model, {Code::kNotConverged, "the cable could not be solved at the length found"});
  }
  const CableSolution solution = problem->describe(options.profile_points);
  // The length's own rounding moves the tension of a stiff cable.
  const double axial_stiffness = problem->cable().axial_stiffness;
  const double rounding = std::isfinite(axial_stiffness) ? 1e-14 * axial_stiffness : 0.0;
  const double accepted = std::max(options.limits.tolerance, kTensionFound) * tension_a;
  if (std::abs(solution.tension_a - tension_a) > accepted + rounding) {
    return refusal(options.model, {Code::kNotConverged, "the length found does not give the tension asked for"});
  }
  return solution;
}

}  // namespace

CableSolution positionOnRung(const CableProperties& properties, double length, double h, double v,
                             const RungOptions& options) {
  const Status check = firstRefusal(checkCable(properties, options.model), checkLength(length),
                                    checkForce("horizontal_force", h), checkForce("vertical_force_a", v));
  if (!check.ok()) return refusal(options.model, check);
  const CableProperties cable = asSeenBy(options.model, properties);
  if (bends(cable, options.model)) {
    MultipleShooting shooting;
    const BendingOutcome outcome = solveBendingPosition(cable, length, {h, v}, options.limits, &shooting);
    return bendingSolution(cable, options, outcome, shooting);
  }
  if (ForcesAtA{h, v}.push()) {
    return refusal(options.model, {Code::kInfeasible, named("horizontal_force", h, "N") +
                                                          " is compression, which only a cable with bending "
                                                          "stiffness can carry: use a bending model"});
  }
  EndPoint end;
  if (isStraight(options.model)) {
    if (std::hypot(h, v - 0.5 * cable.weight * length) == 0.0) {
      return refusal(options.model, {Code::kInvalidInput,
                                     "a straight cable without tension has no direction: its forces leave nothing "
                                     "but its own weight; give more force or use a catenary"});
    }
    end = straightEnd(cable, h, v, length);
  } else {
    if (h == 0.0 && v == 0.0 && cable.weight == 0.0) {
      return refusal(options.model, {Code::kInvalidInput, "a weightless cable without forces has no defined shape"});
    }
    end = correctedCatenaryEnd(cable, h, v, length);
    if (!end.position.allFinite()) return refusal(options.model, noFirstOrder());
  }
  return describeClosedForm(cable, options.model, length, h, v, end.position.x(), end.position.y(),
                            options.profile_points);
}

CableSolution forcesOnRung(const CableProperties& properties, double length, double x, double y,
                           const RungOptions& options) {
  const Status check = firstRefusal(checkCable(properties, options.model), checkLength(length), checkEnd(x, y));
  if (!check.ok()) return refusal(options.model, check);
  const CableProperties cable = asSeenBy(options.model, properties);
  const double chord = std::hypot(x, y);
  if (options.model == Model::kStraight) {
    return refusal(options.model, straightWithoutForces(length, chord, options.limits.tolerance));
  }
  if (isInextensible(options.model) && length <= chord) {
    return refusal(options.model, noForces(cable, length, chord));
  }
  ForcesAlongLength problem(cable, options, x, y);
  if (options.model == Model::kStraightElastic) {
    static_cast<void>(problem.solve(length));
    return problem.describe(options.profile_points);
  }
  if (!bends(cable, options.model)) {
    if (!problem.solve(length)) return refusal(options.model, noForces(cable, length, chord));
    return problem.describe(options.profile_points);
  }
  MultipleShooting shooting;
  const BendingOutcome outcome = solveBendingForces(cable, length, x, y, options.limits, &shooting);
  CableSolution solution = bendingSolution(cable, options, outcome, shooting);
  if (solution.status.ok()) solution.closure_residual = std::hypot(solution.x - x, solution.y - y);
  return solution;
}

CableSolution lengthOnRung(const CableProperties& properties, double x, double y, double tension_a, double length_hint,
                           const RungOptions& options) {
  const Status check =
      firstRefusal(checkCable(properties, options.model), checkEnd(x, y), checkEndsApart(x, y),
                   checkPositive("tension_a", tension_a, kLargestForce, "N"),
                   length_hint <= 0.0 ? Status{Code::kConverged, ""}
                                      : checkPositive("length_hint", length_hint, kLargestLength, "m"));
  if (!check.ok()) return refusal(options.model, check);
  const double chord = std::hypot(x, y);
  const CableProperties cable = asSeenBy(options.model, properties);
  if (options.model == Model::kStraight) return straightLength(cable, x, y, tension_a, options);
  if (isInextensible(options.model)) {
    if (const auto string = stringLength(cable, x, y, tension_a, length_hint, options)) return *string;
  }

  LengthSearch search;
  search.tension = tension_a;
  search.chord = chord;
  search.hint = length_hint;
  search.tolerance = options.limits.tolerance;
  search.longest = 4.0 * chord;
  if (cable.weight > 0.0) search.longest = 2.0 * chord + 1.2 * (2.0 * tension_a / cable.weight + chord);
  if (isStraight(options.model)) search.longest = chord * (1.0 - 1e-15);
  // From the hint's own shape: one followed from far away may be another.
  ForcesAlongLength at_hint(cable, options, x, y);
  if (length_hint > 0.0) {
    search.near_hint = rootNearHint([&](double length) { return at_hint.sample(length); }, search);
    if (search.near_hint && isAtHint(*search.near_hint, search)) {
      return atLengthFound(*search.near_hint, tension_a, options, &at_hint);
    }
  }
  ForcesAlongLength problem(cable, options, x, y);
  const TensionCurve curve = [&](double length) { return problem.sample(length); };
  double more = isBending(options.model) ? 0.02 : 2.0 + cable.weight * chord / tension_a;
  for (int i = 0; i < 20; ++i, more *= 4.0) {
    search.shortest = tautLength(cable, x, y, tension_a * (1.0 + more), options);
    const std::optional<TensionSample> sample = curve(search.shortest);
    if (!sample) break;
    // In compression the tension falls again beyond the fold: not the taut side.
    if (sample->tension > tension_a && sample->slope < 0.0 && problem.pulls()) break;
  }
  const LengthFound found = searchLength(curve, search);
  if (SolveLimits::Clock::now() > options.limits.deadline) {
    return refusal(options.model, {Code::kTimedOut, "the time allowed ran out while looking for the length"});
  }
  if (!found.length) {
    if (found.complete) return belowLeastTension(options.model, tension_a, found.least_tension);
    return refusal(options.model, {Code::kNotConverged, "the tension could not be followed along the length"});
  }
  return atLengthFound(*found.length, tension_a, options, found.length == search.near_hint ? &at_hint : &problem);
}

}  // namespace cdpr_kinetostatics
