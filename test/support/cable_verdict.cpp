#include "cable_verdict.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "collocation.h"
#include "single_shooting.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

// The shape that the check starts from: enough points to resolve layers where the catenary's shape is no start.
constexpr int kProfilePoints = 401;

// A length counts as the hinted one, and a shape as the same, if they differ by less than this share.
constexpr double kSame = 1e-4;

template <typename Solve>
CableSolution timed(const JudgeOptions& options, Judged* judged, const Solve& solve) {
  CableSolverOptions solver;
  solver.tolerance = options.tolerance;
  const Clock::time_point start = Clock::now();
  solver.timeout = std::chrono::duration<double>(options.timeout);
  CableSolution solution = solve(solver);
  judged->time = std::chrono::duration<double>(Clock::now() - start).count();
  judged->code = solution.status.code;
  judged->message = solution.status.message;
  judged->iterations = solution.iterations;
  judged->outcome = Outcome::kRefused;
  return solution;
}

double largerTension(const CableProperties& cable, double length, double h, double v) {
  return std::max(
      {std::hypot(h, v), std::hypot(h, v - cable.weight * length), 1e-3 * cable.bending_stiffness / (length * length)});
}

struct Check {
  VerifiedCable verified;
  double error = 0.0;  // of the claim
};

// From the direction of the force alone; if that ends elsewhere, from the claimed shape.
template <typename Error, typename Profile>
Check check(ClaimedCable claim, Kept kept, double accuracy, const Error& error, const Profile& profile) {
  Check result{verify(claim, kept), 0.0};
  if (result.verified.converged) result.error = error(result.verified);
  if (result.verified.converged && result.error <= accuracy && result.verified.sags()) return result;
  claim.profile = profile();
  const VerifiedCable again = verify(claim, kept);
  if (again.converged && (!result.verified.converged || error(again) <= result.error)) result = {again, error(again)};
  return result;
}

Outcome outcomeOf(const Check& check, double accuracy, bool asked_for) {
  if (!check.verified.converged || !(check.error < 0.01)) return Outcome::kUnverified;
  if (!asked_for) return Outcome::kWrongBranch;
  return check.error <= accuracy ? Outcome::kSolved : Outcome::kInaccurate;
}

CableSolverOptions withProfile(const JudgeOptions& options) {
  CableSolverOptions solver;
  solver.tolerance = options.tolerance;
  solver.profile_points = kProfilePoints;
  return solver;
}

}  // namespace

const char* outcomeName(Outcome outcome) {
  switch (outcome) {
    case Outcome::kNotAsked:
      return "not asked";
    case Outcome::kSolved:
      return "solved";
    case Outcome::kRefused:
      return "refused";
    case Outcome::kInaccurate:
      return "inaccurate";
    case Outcome::kWrongBranch:
      return "wrong branch";
    default:
      return "unverified";
  }
}

CableVerdict judge(const ExtremeCable& c, const JudgeOptions& options) {
  CableVerdict verdict;
  verdict.hinted = options.hinted;

  // Problem 2.
  const CableSolution held =
      timed(options, &verdict.forces, [&](const auto& o) { return findForces(c.cable, c.length, c.x, c.y, o); });
  VerifiedCable truth;
  if (held.status.ok()) {
    const ClaimedCable claim{c.cable, c.length, c.x, c.y, held.horizontal_force, held.vertical_force_a, {}};
    const Check checked = check(
        claim, Kept::kEndPoint, options.accuracy,
        [&](const VerifiedCable& found) {
          return std::hypot(found.h - claim.h, found.v - claim.v) / largerTension(c.cable, c.length, found.h, found.v);
        },
        [&] { return findForces(c.cable, c.length, c.x, c.y, withProfile(options)).profile; });
    truth = checked.verified;
    verdict.forces.error = checked.error;
    verdict.forces.outcome = outcomeOf(checked, options.accuracy, truth.sags());
    verdict.h = truth.h;
    verdict.v = truth.v;
  }

  const Clock::time_point start = Clock::now();
  const SingleShooting single = shootSingly(c.cable, c.length, c.x, c.y, options.tolerance);
  verdict.single.time = std::chrono::duration<double>(Clock::now() - start).count();
  verdict.single.iterations = single.iterations;
  verdict.single.outcome = Outcome::kRefused;
  verdict.single.code = single.converged ? Code::kConverged : Code::kNotConverged;
  if (single.converged && verdict.forces.outcome == Outcome::kSolved) {
    verdict.single.error =
        std::hypot(single.h - truth.h, single.v - truth.v) / largerTension(c.cable, c.length, truth.h, truth.v);
    verdict.single.outcome = verdict.single.error <= options.accuracy ? Outcome::kSolved
                             : verdict.single.error < 0.01            ? Outcome::kInaccurate
                                                                      : Outcome::kWrongBranch;
  }
  if (verdict.forces.outcome != Outcome::kSolved) return verdict;

  // Problem 1. Under tension there is one place; in compression any sagging equilibrium with x >= 0 answers.
  const CableSolution placed = timed(
      options, &verdict.position, [&](const auto& o) { return findPosition(c.cable, c.length, truth.h, truth.v, o); });
  if (placed.status.ok()) {
    const ClaimedCable claim{c.cable, c.length, placed.x, placed.y, truth.h, truth.v, {}};
    const Check checked = check(
        claim, Kept::kForces, options.accuracy,
        [&](const VerifiedCable& found) { return std::hypot(found.x - claim.x, found.y - claim.y) / c.length; },
        [&] { return findPosition(c.cable, c.length, truth.h, truth.v, withProfile(options)).profile; });
    const bool there = std::hypot(placed.x - c.x, placed.y - c.y) < kSame * c.length;
    const bool pulls = truth.h > 0.0 && c.x * truth.h + c.y * (0.5 * c.cable.weight * c.length - truth.v) > 0.0;
    const bool asked_for = checked.verified.sags() && (there || !pulls) && placed.x >= -kSame * c.length;
    verdict.position.error = checked.error;
    verdict.position.outcome = outcomeOf(checked, options.accuracy, asked_for);
  }

  // Problem 3.
  const double tension = std::hypot(truth.h, truth.v);
  if (!(tension > 0.0)) return verdict;
  const CableSolution cut = timed(options, &verdict.length, [&](const auto& o) {
    return findLength(c.cable, c.x, c.y, tension, options.hinted ? c.length : 0.0, o);
  });
  if (cut.status.ok()) {
    const ClaimedCable claim{c.cable, cut.length, c.x, c.y, cut.horizontal_force, cut.vertical_force_a, {}};
    const Check checked = check(
        claim, Kept::kEndPoint, options.accuracy,
        [&](const VerifiedCable& found) {
          return std::abs(std::hypot(found.h, found.v) - tension) /
                 largerTension(c.cable, cut.length, found.h, found.v);
        },
        [&] { return findForces(c.cable, cut.length, c.x, c.y, withProfile(options)).profile; });
    const bool asked_for =
        options.hinted ? std::abs(cut.length - c.length) <= kSame * c.length : cut.length <= (1.0 + kSame) * c.length;
    verdict.length.error = checked.error;
    verdict.length.outcome = outcomeOf(checked, options.accuracy, checked.verified.sags() && asked_for);
  }
  return verdict;
}

}  // namespace cdpr_kinetostatics
