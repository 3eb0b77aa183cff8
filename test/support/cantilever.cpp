#include "cantilever.h"

#include <cmath>

namespace cdpr_kinetostatics {

CantileverTip solveCantilever(const Cantilever& c, double tolerance) {
  // Forces are measured in EI/L^2, lengths in L.
  const double force = c.beam.bending_stiffness / (c.length * c.length);
  ShotParameters parameters;
  parameters.h = c.tip_x / force;
  parameters.q = c.beam.weight * c.length / force;
  parameters.v = parameters.q - c.tip_w / force;
  parameters.eps = force / c.beam.axial_stiffness;

  CantileverTip tip;
  StepGrid grid;
  Shot shot;
  double moment = 0.0;
  // The load is raised in steps: the free end's moment alone is no convex function of the clamp's.
  constexpr int kLoadSteps = 20;
  for (int load = 1; load <= kLoadSteps; ++load) {
    ShotParameters p = parameters;
    for (double* value : {&p.h, &p.v, &p.q}) *value *= static_cast<double>(load) / kLoadSteps;
    bool solved = false;
    for (int i = 0; i < 50 && !solved; ++i) {
      const ShotState start{0.0, moment, 0.0, 0.0};
      const bool adapt = i < 3;
      if (!(adapt ? shootAdaptive(p, 0.0, 1.0, start, tolerance, &grid, &shot)
                  : shootOnGrid(p, 0.0, start, grid, 1.0, &shot))) {
        return tip;
      }
      const double change = -shot.end.moment / shot.sensitivity(1, 1);
      moment += change;
      solved = !adapt && std::abs(change) < 1e-14 * (1.0 + std::abs(moment));
    }
    if (!solved) return tip;
  }
  tip.solved = true;
  tip.x = shot.end.x * c.length;
  tip.y = shot.end.y * c.length;
  tip.alpha = shot.end.alpha;
  tip.clamp_moment = moment * force * c.length;
  return tip;
}

}  // namespace cdpr_kinetostatics
