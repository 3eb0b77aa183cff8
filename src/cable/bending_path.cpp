#include "cable/bending_path.h"

#include <algorithm>

namespace cdpr_kinetostatics {
namespace {

// Steps of the share. They shrink faster than they grow, so that half of a path's steps succeed at least where the
// longest possible step stays the same: 1.7 * 0.4 < 1. Below the shortest the path is lost: it would take more steps
// than any path has.
constexpr double kFirstStep = 0.25;
constexpr double kGrowth = 1.7;
constexpr double kShrinking = 0.4;
constexpr double kShortestStep = 1e-5;

}  // namespace

SolveOutcome followPath(const SolveOutcome& start, int max_steps, const char* lost, const SolveAtShare& solve,
                        MultipleShooting* shooting) {
  SolveOutcome outcome = start;
  MultipleShooting last = *shooting;
  double share = 0.0;
  double step = kFirstStep;
  for (int i = 0; i < max_steps && share < 1.0 && step >= kShortestStep; ++i) {
    const double next = std::min(1.0, share + step);
    const SolveOutcome local = solve(next);
    outcome.count(local);
    if (local.status.code == Code::kTimedOut) {
      outcome.status = local.status;
      return outcome;
    }
    if (local.status.ok()) {
      last = *shooting;
      share = next;
      step *= kGrowth;
    } else {
      shooting->restore(last);
      step *= kShrinking;
    }
  }
  if (share < 1.0) outcome.status = {Code::kNotConverged, lost};
  return outcome;
}

}  // namespace cdpr_kinetostatics
