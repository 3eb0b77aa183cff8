#include "single_shooting.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "cable/catenary.h"
#include "cable/shot.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kMaxIterations = 40;

}  // namespace

SingleShooting shootSingly(const CableProperties& cable, double length, double x, double y, double tolerance) {
  SingleShooting result;
  const double chord = std::hypot(x, y);
  const std::optional<ForcesAtA> catenary = catenaryForces(cable, length, x, y);
  const ForcesAtA start = catenary.value_or(ForcesAtA{0.0, 0.5 * cable.weight * length});
  const double force = std::max({std::hypot(start.horizontal, start.vertical),
                                 std::hypot(start.horizontal, start.vertical - cable.weight * length),
                                 cable.bending_stiffness / (length * length)});
  const double layer = std::sqrt(cable.bending_stiffness / force);
  const double span = length / layer;
  ShotParameters p{0.0, 0.0, cable.weight * layer / force, force / cable.axial_stiffness};
  const Eigen::Vector2d end = Eigen::Vector2d(x, y) / length;

  Eigen::Vector3d unknown(catenaryAngle(cable, start.horizontal, start.vertical, 0.0), start.horizontal / force,
                          start.vertical / force);
  if (start.horizontal == 0.0) unknown[0] = std::atan2(y, x == 0.0 ? 1e-3 * chord : x);
  Eigen::Matrix3d jacobian;
  const auto residual = [&](const Eigen::Vector3d& u) -> std::optional<Eigen::Vector3d> {
    p.h = u[1];
    p.v = u[2];
    StepGrid grid;
    Shot shot;
    const double step = 0.1 * tolerance;
    if (!shootAdaptive(p, 0.0, span, {u[0], 0.0, 0.0, 0.0}, step, &grid, &shot)) return std::nullopt;
    for (int row = 0; row < 3; ++row) {
      jacobian.row(row) << shot.sensitivity(row + 1, 0), shot.sensitivity(row + 1, 2), shot.sensitivity(row + 1, 3);
      if (row > 0) jacobian.row(row) /= span;
    }
    return Eigen::Vector3d(shot.end.moment, shot.end.x / span - end.x(), shot.end.y / span - end.y());
  };
  for (int i = 0; i < kMaxIterations; ++i) {
    result.iterations = i + 1;
    const std::optional<Eigen::Vector3d> defect = residual(unknown);
    if (!defect) return result;
    const Eigen::Vector3d change = -(jacobian.inverse() * *defect);
    if (!change.allFinite()) return result;
    unknown += change;
    if (change.norm() > tolerance * unknown.norm()) continue;
    result.converged = defect->norm() <= 100.0 * tolerance;
    result.angle_a = unknown[0];
    result.h = force * unknown[1];
    result.v = force * unknown[2];
    return result;
  }
  return result;
}

}  // namespace cdpr_kinetostatics
