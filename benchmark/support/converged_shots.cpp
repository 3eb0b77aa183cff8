#include "support/converged_shots.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kLayersPerShot = 3.0;

}  // namespace

std::vector<ShotProblem> convergedShots(const RobotDescription& robot, const Pose& pose, double most_layers) {
  const RobotSolution solution = solveInverse(robot, requestFor(robot, pose), patient(Model::kBending, 1e-12));
  if (!solution.report.status.ok()) throw std::runtime_error(solution.report.status.message);
  std::vector<ShotProblem> shots;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CableProperties& cable = robot.cables[i].properties;
    const CableSolution& known = solution.cables[i].cable;
    const double force = std::max(known.tension_a, known.tension_b);
    const double layer = std::sqrt(cable.bending_stiffness / force);
    const double span = known.length / layer;
    const int count = std::max(1, static_cast<int>(std::ceil(span / kLayersPerShot)));
    CableSolverOptions options;
    options.tolerance = 1e-12;
    options.profile_points = count + 1;
    const CableSolution fine = findForces(cable, known.length, known.x, known.y, options);
    if (!fine.status.ok()) throw std::runtime_error(fine.status.message);
    for (int k = 0; k < count; ++k) {
      const double t0 = span * k / count;
      const double t1 = span * (k + 1) / count;
      if (t1 > most_layers && span - t0 > most_layers) continue;
      const ProfilePoint& from = fine.profile[k];
      shots.push_back({{fine.horizontal_force / force, fine.vertical_force_a / force, cable.weight * layer / force,
                        force / cable.axial_stiffness},
                       t0,
                       t1,
                       {from.alpha, from.moment / (force * layer), 0.0, 0.0}});
    }
  }
  return shots;
}

}  // namespace cdpr_kinetostatics
