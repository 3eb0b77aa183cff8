#include "robot_closure_states.h"

#include <cmath>
#include <limits>

#include "cable/pulley_cable.h"
#include "cable/rope_on_pulley.h"

namespace cdpr_kinetostatics {

namespace {

// With some margin for forces nearby.
bool liesOnPulley(const CableProperties& cable, const ForcesAtA& forces) {
  const double thickness = std::sqrt(cable.bending_stiffness / forces.tension());
  return !hasPulley(cable) ||
         (thickness < 0.7 * cable.pulley.radius && checkContact(cable, forces, tautDeparture(cable, forces)).ok());
}

}  // namespace

ClosureState randomClosure(const ClosureKind& kind, Dice* dice) {
  for (;;) {
    ClosureState state;
    state.cable = {std::exp(dice->uniform(10.0, 14.0)), std::exp(dice->uniform(-3.0, 1.0)), dice->uniform(0.2, 4.0)};
    if (kind.inextensible) state.cable.axial_stiffness = std::numeric_limits<double>::infinity();
    state.cable.dead_length = kind.dead_length;
    if (kind.pulley_radius > 0.0) {
      state.cable.pulley = {kind.pulley_radius, dice->uniform(0.0, 1.0) < 0.5 ? RopeFrom::kBelow : RopeFrom::kAbove};
    }
    state.chord = dice->uniform(2.0, 12.0);
    const double sine = kind.beside < 0.0 ? dice->uniform(-kind.steepest, kind.steepest) : -1.0;
    const double x = state.chord * (kind.beside < 0.0 ? std::sqrt(1.0 - sine * sine) : kind.beside);
    const double heading = dice->uniform(-3.1, 3.1);
    const Eigen::Vector3d to_b(x * std::cos(heading), x * std::sin(heading), state.chord * sine);
    state.anchor = dice->inBox({-5.0, -5.0, 2.0}, {5.0, 5.0, 6.0});
    state.attachment = dice->inBox({-0.6, -0.6, -0.6}, {0.6, 0.6, 0.6});
    const Eigen::Quaterniond attitude = dice->attitude();
    const Eigen::Vector3d position = state.anchor + to_b - attitude * state.attachment;
    if (!checkReach(state.cable.pulley, x, to_b.z()).ok()) continue;
    const double length =
        straightWay(state.cable, x, to_b.z()) * (1.0 + dice->uniform(kind.least_excess, kind.most_excess));
    const auto forces = hangingForces(state.cable, length, std::max(x, 1e-6 * state.chord), to_b.z());
    if (!forces || !(forces->horizontal > 0.0) || !liesOnPulley(state.cable, *forces)) continue;
    // A hanging cable that just touches its lower end has a kink there, which differences see.
    if (kind.beside > 0.0 && forces->vertical < 1.5 * state.cable.weight * length) continue;
    const Eigen::Vector2d force(forces->horizontal / std::max(x, 1e-6 * state.chord) * dice->uniform(0.9, 1.1),
                                forces->vertical * dice->uniform(0.9, 1.1));
    state.parameters = {position, attitude.coeffs(), force, Eigen::VectorXd::Constant(1, length)};
    return state;
  }
}

}  // namespace cdpr_kinetostatics
