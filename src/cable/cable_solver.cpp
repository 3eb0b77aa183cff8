#include "cdpr_kinetostatics/cable/cable_solver.h"

#include <sstream>
#include <string>

#include "cable/cable_checks.h"
#include "cable/rung_error.h"
#include "cable/rung_problems.h"

namespace cdpr_kinetostatics {
namespace {

void estimateError(const CableProperties& cable, CableSolution* solution) {
  if (!solution->status.ok()) return;
  const RungError error = rungError(cable, *solution);
  solution->estimated_error = error.displacement;
  solution->error_known = error.known;
}

// True if the rung's solution is known to be as accurate as asked for.
bool isWithin(const CableProperties& cable, double accuracy, const CableSolution& solution) {
  const RungError error = rungError(cable, solution);
  return error.known && error.displacement <= kAutoShare * accuracy;
}

// Solves on the coarsest rung that is accurate enough: solve(options) is the problem on options.model. The catenary
// comes first, for it says what the others are worth.
template <typename Solve>
CableSolution solveAuto(const CableProperties& cable, double accuracy, const RungOptions& rung, const Solve& solve) {
  RungOptions on_rung = rung;
  on_rung.model = Model::kCatenary;
  const CableSolution catenary = solve(on_rung);
  if (catenary.status.code == Code::kInvalidInput) return catenary;
  if (catenary.status.ok()) {
    const RungErrors errors = rungErrors(cable, catenary.length, catenary.horizontal_force, catenary.vertical_force_a);
    for (std::size_t r = 0; kAutoRungs[r] != Model::kBending; ++r) {
      if (!errors[r].known || errors[r].end.norm() > kAutoShare * accuracy) continue;
      on_rung.model = kAutoRungs[r];
      const CableSolution solution = on_rung.model == Model::kCatenary ? catenary : solve(on_rung);
      if (solution.status.ok() && isWithin(cable, accuracy, solution)) return solution;
    }
  }
  on_rung.model = Model::kBending;
  return solve(on_rung);
}

std::string describeChoice(const CableSolution& solution) {
  if (solution.model == Model::kBending) return "bending: no coarser model is known to be accurate enough";
  std::ostringstream text;
  text.precision(2);
  text << modelName(solution.model) << " was accurate enough: what it neglects moves the end by "
       << solution.estimated_error << " m";
  return text.str();
}

template <typename Solve>
CableSolution solveOnLadder(const CableProperties& cable, const CableSolverOptions& options, const Solve& solve) {
  CableSolution solution;
  solution.model = options.model;
  solution.status = checkOptions(options);
  if (!solution.status.ok()) return solution;
  const RungOptions rung{options.model, {options.tolerance, deadlineAfter(options.timeout)}, options.profile_points};
  solution = options.model == Model::kAuto ? solveAuto(cable, options.accuracy, rung, solve) : solve(rung);
  estimateError(cable, &solution);
  if (options.model == Model::kAuto && solution.status.ok()) solution.status.message = describeChoice(solution);
  return solution;
}

}  // namespace

CableSolution findPosition(const CableProperties& cable, double length, double h, double v,
                           const CableSolverOptions& options) {
  return solveOnLadder(cable, options,
                       [&](const RungOptions& on_rung) { return positionOnRung(cable, length, h, v, on_rung); });
}

CableSolution findForces(const CableProperties& cable, double length, double x, double y,
                         const CableSolverOptions& options) {
  return solveOnLadder(cable, options,
                       [&](const RungOptions& on_rung) { return forcesOnRung(cable, length, x, y, on_rung); });
}

CableSolution findLength(const CableProperties& cable, double x, double y, double tension_a, double length_hint,
                         const CableSolverOptions& options) {
  return solveOnLadder(cable, options, [&](const RungOptions& on_rung) {
    return lengthOnRung(cable, x, y, tension_a, length_hint, on_rung);
  });
}

}  // namespace cdpr_kinetostatics
