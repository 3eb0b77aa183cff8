#include "estimation/estimate_error.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>

#include "cable/auto_policy.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

// A direction of the unknowns counts as fixed if more than this share of it is seen.
constexpr double kRank = 1e-9;

Eigen::Index count(const std::vector<bool>& flags) { return std::count(flags.begin(), flags.end(), true); }

// A direction that the data cannot fix does not move. At a fixed pose and H the other end means another V and L, so the
// cable's residuals change; the adjustment follows.
std::vector<Eigen::Matrix<double, 6, 2>> solvePoseByEnd(const MeasuredRobot& measured, const Candidate& candidate) {
  const RobotDescription& robot = measured.robot;
  const EstimatorOptions& options = measured.options;
  const Selection& selection = candidate.selection;
  const Adjusted& adjusted = candidate.adjusted;
  const Eigen::Index freedoms = robot.freedoms();
  const auto cables = static_cast<Eigen::Index>(robot.cables.size());

  Eigen::MatrixXd residuals = Eigen::MatrixXd::Zero(adjusted.jacobian.rows(), 2 * cables);
  Eigen::Index length_row = 0;
  Eigen::Index tension_row = count(selection.lengths);
  for (Eigen::Index i = 0; i < cables; ++i) {
    const SaggingCable& cable = adjusted.cables[i];
    const Eigen::Matrix2d by_end = -cable.end().jacobian.rightCols<2>().inverse();  // of (V, L)
    auto of_cable = residuals.middleCols<2>(2 * i);
    if (selection.lengths[i]) of_cable.row(length_row++) = by_end.row(1) / options.length_stddev;
    if (selection.tensions[i]) {
      of_cable.row(tension_row++) = cable.verticalForceA() / cable.tensionA() * by_end.row(0) / options.tension_stddev;
    }
    if (selection.load.any()) {
      const Wrench up = wrenchAt(cablePlane(robot.cables[i], adjusted.unknowns.pose).arm, Eigen::Vector3d::UnitZ());
      const Wrench weight = (selection.load.cast<double>() / options.load_stddev.array()).matrix();
      const Eigen::RowVector2d vertical = by_end.row(0) - robot.cables[i].properties.weight * by_end.row(1);
      of_cable.bottomRows(freedoms) = up.cwiseProduct(weight).head(freedoms) * vertical;
    }
  }
  const Eigen::VectorXd norms = adjusted.jacobian.colwise().norm().cwiseMax(1e-300);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least_squares(adjusted.jacobian *
                                                                        norms.cwiseInverse().asDiagonal());
  least_squares.setThreshold(kRank);
  const Eigen::MatrixXd moved = -(norms.cwiseInverse().asDiagonal() * least_squares.solve(residuals));
  std::vector<Eigen::Matrix<double, 6, 2>> result(robot.cables.size(), Eigen::Matrix<double, 6, 2>::Zero());
  for (Eigen::Index i = 0; i < cables; ++i) {
    if (moved.middleCols<2>(2 * i).allFinite()) {
      result[i].topRows(freedoms) = moved.block(0, 2 * i, freedoms, 2);
    }
  }
  return result;
}

const std::vector<Eigen::Matrix<double, 6, 2>>& poseByEnd(const MeasuredRobot& measured, Candidate* candidate) {
  if (candidate->pose_by_end.empty()) candidate->pose_by_end = solvePoseByEnd(measured, *candidate);
  return candidate->pose_by_end;
}

// More is available than there are unknowns: the pose and one H per cable.
bool areChecked(const MeasuredRobot& measured) {
  const Selection& available = measured.available;
  return count(available.lengths) + count(available.tensions) + available.load.count() >
         measured.robot.freedoms() + static_cast<Eigen::Index>(measured.robot.cables.size());
}

// What shows of a cable whose end lay elsewhere in (x, y), in its own length, its tension and the load, as far as they
// are available [standard deviations/m]: the least that some H leaves, so no residual's test exceeds its norm
// (docs/theory.md section 5).
Eigen::Matrix<double, 8, 2> visibleByEnd(const MeasuredRobot& measured, const Candidate& candidate, std::size_t i) {
  const EstimatorOptions& options = measured.options;
  const SaggingCable& cable = candidate.adjusted.cables[i];
  const CablePlane plane = cablePlane(measured.robot.cables[i], candidate.adjusted.unknowns.pose);
  Eigen::Matrix<double, 8, 3> by_state = Eigen::Matrix<double, 8, 3>::Zero();  // length, tension, load by (H, V, L)
  if (measured.available.lengths[i]) by_state(0, 2) = 1.0 / options.length_stddev;
  if (measured.available.tensions[i]) {
    by_state.row(1) << cable.horizontalForce(), cable.verticalForceA(), 0.0;
    by_state.row(1) /= cable.tensionA() * options.tension_stddev;
  }
  const Wrench weight = (measured.available.load.cast<double>() / options.load_stddev.array()).matrix();
  const Wrench up = wrenchAt(plane.arm, Eigen::Vector3d::UnitZ());
  by_state.bottomRows<6>() << wrenchByForces(plane), -measured.robot.cables[i].properties.weight * up;
  by_state.bottomRows<6>() = weight.asDiagonal() * by_state.bottomRows<6>();

  const Eigen::Matrix<double, 2, 3>& end = cable.end().jacobian;
  const Eigen::Matrix2d by_end = -end.rightCols<2>().inverse();  // of (V, L)
  Eigen::Matrix<double, 8, 2> visible = by_state.rightCols<2>() * by_end;
  const Eigen::Matrix<double, 8, 1> by_h = by_state.col(0) + by_state.rightCols<2>() * by_end * end.col(0);
  if (by_h.norm() > 0.0) visible -= by_h.normalized() * (by_h.normalized().transpose() * visible);
  return visible;
}

}  // namespace

std::vector<RungEffects> rungEffects(const MeasuredRobot& measured, Candidate* candidate,
                                     const std::vector<Model>& kept) {
  const bool checked = areChecked(measured);
  const std::vector<Eigen::Matrix<double, 6, 2>>& pose_by_end = poseByEnd(measured, candidate);
  const RobotForces& at = candidate->adjusted.unknowns;
  std::vector<RungEffects> effects(pose_by_end.size());
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const RungErrors errors =
        rungErrors(measured.robot.cables[i].properties, at.lengths[i], at.forces[i].horizontal, at.forces[i].vertical);
    const Eigen::Matrix<double, 8, 2> visible = visibleByEnd(measured, *candidate, i);
    for (std::size_t r = 0; r < errors.size(); ++r) {
      const bool coarser = !kept.empty() && kAutoRungs[r] < kept[i];
      const double limit = (coarser ? kCoarserShare : 1.0) * kInvisible;
      effects[i].displacement[r] = pose_by_end[i] * errors[r].end;
      effects[i].displacement[r].tail<3>() *= measured.robot.platformRadius();
      effects[i].known[r] = errors[r].known && !(checked && (visible * errors[r].end).norm() > limit);
    }
  }
  return effects;
}

void reportEffect(const MeasuredRobot& measured, Candidate* candidate, RobotSolution* solution) {
  const std::vector<Eigen::Matrix<double, 6, 2>>& pose_by_end = poseByEnd(measured, candidate);
  Wrench moved = Wrench::Zero();
  for (std::size_t i = 0; i < pose_by_end.size(); ++i) {
    moved += pose_by_end[i] * rungError(measured.robot.cables[i].properties, solution->cables[i].cable).end;
  }
  solution->report.estimated_error = moved.head<3>().norm();
  solution->report.estimated_rotation_error = moved.tail<3>().norm();
}

}  // namespace cdpr_kinetostatics
