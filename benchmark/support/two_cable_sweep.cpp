#include "support/two_cable_sweep.h"

#include <cmath>
#include <limits>

namespace cdpr_kinetostatics {
namespace {

constexpr int kHalf = 2;             // grid points on each side of the middle
constexpr double kRounding = 1e-15;  // narrowest grid, relative to the forces

class Sweep {
 public:
  Sweep(const RobotDescription& robot, const Eigen::Vector2d& lengths, const CableSolverOptions& options)
      : robot_(robot), lengths_(lengths), options_(options) {}

  SweptPoint run(const Eigen::Vector2d& around, double share, double gap) {
    best_.forces = around;
    best_.gap = std::numeric_limits<double>::infinity();
    Eigen::Vector2d half_width = share * around.cwiseAbs();
    while (best_.gap > gap && half_width.norm() > kRounding * around.norm()) {
      if (!movesToTheRim(half_width)) half_width *= 0.5;
    }
    return best_;
  }

 private:
  // Tries every pair on the grid around the best one; true if the new best one lies on the grid's rim.
  bool movesToTheRim(const Eigen::Vector2d& half_width) {
    const Eigen::Vector2d middle = best_.forces;
    bool rim = false;
    for (int i = -kHalf; i <= kHalf; ++i) {
      for (int k = -kHalf; k <= kHalf; ++k) {
        const Eigen::Vector2d share(static_cast<double>(i) / kHalf, static_cast<double>(k) / kHalf);
        if (tryForces(middle + share.cwiseProduct(half_width))) rim = share.cwiseAbs().maxCoeff() == 1.0;
      }
    }
    return rim;
  }

  bool tryForces(const Eigen::Vector2d& forces) {
    const CableDescription& first = robot_.cables[0];
    const CableDescription& second = robot_.cables[1];
    const double vertical_2 =
        robot_.weight() + first.properties.weight * lengths_.x() + second.properties.weight * lengths_.y() - forces.y();
    const CableSolution end_1 = findPosition(first.properties, lengths_.x(), forces.x(), forces.y(), options_);
    const CableSolution end_2 = findPosition(second.properties, lengths_.y(), forces.x(), vertical_2, options_);
    best_.cable_solves += 2;
    if (!end_1.status.ok() || !end_2.status.ok()) return false;
    const Eigen::Vector2d mass_1(first.anchor.x() + end_1.x, first.anchor.z() + end_1.y);
    const Eigen::Vector2d mass_2(second.anchor.x() - end_2.x, second.anchor.z() + end_2.y);
    const double gap = (mass_1 - mass_2).norm();
    if (gap >= best_.gap) return false;
    best_.position = 0.5 * (mass_1 + mass_2);
    best_.forces = forces;
    best_.tension_2 = end_2.tension_a;
    best_.gap = gap;
    return true;
  }

  const RobotDescription& robot_;
  const Eigen::Vector2d lengths_;
  const CableSolverOptions options_;
  SweptPoint best_;
};

}  // namespace

SweptPoint sweepForces(const RobotDescription& robot, const Eigen::Vector2d& lengths, const Eigen::Vector2d& around,
                       double share, double gap, const CableSolverOptions& options) {
  return Sweep(robot, lengths, options).run(around, share, gap);
}

}  // namespace cdpr_kinetostatics
