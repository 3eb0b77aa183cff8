#include "robot/quadratic_program.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "robot/nearest_in_polytope.h"
#include "robot/null_space.h"

namespace cdpr_kinetostatics {
namespace {

// Curvatures below this share of the largest count as that much: a direction without curvature has no nearest point.
constexpr double kLeastCurvature = 1e-9;

// Accepted violation of an inequality, relative to the variables' size.
constexpr double kLimitTolerance = 1e-12;

// Price of what is left of the equations, relative to the variables' own curvature: high enough for as little as
// possible to be left, low enough for the digits of a double to hold both.
constexpr double kImbalancePrice = 1e4;

// In the coordinates of equations and curvature, where the program asks for the point of a polytope nearest to another.
QuadraticStep solveInNullSpace(const QuadraticProgram& program, SolveLimits::Clock::time_point deadline) {
  const auto scale = program.scale.asDiagonal();
  const Eigen::MatrixXd hessian = scale * program.hessian * scale;
  const Eigen::VectorXd gradient = scale * program.gradient;
  const NullSpace space = nullSpace(program.matrix * scale, program.right);
  const Eigen::VectorXd& particular = space.particular;
  const Eigen::MatrixXd& null = space.directions;

  QuadraticStep step;
  step.imbalance = space.imbalance;
  Eigen::MatrixXd free = null;  // columns: directions of unit curvature
  Eigen::VectorXd nearest = Eigen::VectorXd::Zero(null.cols());
  if (null.cols() > 0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(null.transpose() * hessian * null);
    const double largest = std::max(eigen.eigenvalues().cwiseAbs().maxCoeff(), 1e-300);
    const Eigen::VectorXd stretch =
        eigen.eigenvalues().cwiseAbs().cwiseMax(kLeastCurvature * largest).cwiseSqrt().cwiseInverse();
    free = null * eigen.eigenvectors() * stretch.asDiagonal();
    nearest = -free.transpose() * (gradient + hessian * particular);
  }
  const Eigen::MatrixXd normals = free.transpose() * (scale * program.normals);
  const Eigen::VectorXd bounds = program.bounds - program.normals.transpose() * (scale * particular);
  // Each inequality in the unit of its own normal.
  Eigen::MatrixXd unit = normals;
  Eigen::VectorXd unit_bounds = bounds;
  double size = 1e-300;
  for (Eigen::Index k = 0; k < bounds.size(); ++k) {
    const double norm = std::max(normals.col(k).norm(), 1e-12 * (scale * program.normals.col(k)).norm());
    unit.col(k) /= norm;
    unit_bounds(k) /= norm;
  }
  size = std::max(size, nearest.norm());
  const NearestPoint found = nearestInPolytope(nearest, unit, unit_bounds, kLimitTolerance * size, deadline);
  step.feasible = found.feasible;
  step.active = found.active;
  step.change = scale * (particular + free * found.x);
  return step;
}

}  // namespace

QuadraticStep solveQuadraticProgram(const QuadraticProgram& program, SolveLimits::Clock::time_point deadline) {
  QuadraticStep step = solveInNullSpace(program, deadline);
  const Eigen::Index n = program.gradient.size();
  const Eigen::Index rows = program.right.size();
  if (step.feasible) {
    // B v + c = A^T multipliers + N_active (their own).
    Eigen::MatrixXd directions(n, rows + static_cast<Eigen::Index>(step.active.size()));
    directions << program.matrix.transpose(), program.normals(Eigen::all, step.active);
    const auto scale = program.scale.asDiagonal();
    const Eigen::VectorXd pushes = scale * (program.hessian * step.change + program.gradient);
    // Each column by its own size: newtons and radians are not to be compared.
    Eigen::MatrixXd scaled = scale * directions;
    const Eigen::VectorXd sizes = scaled.colwise().norm().transpose().cwiseMax(1e-300);
    scaled = scaled * sizes.cwiseInverse().asDiagonal();
    const Eigen::VectorXd all = scaled.colPivHouseholderQr().solve(pushes).cwiseQuotient(sizes);
    step.multipliers = all.head(rows);
    if (!step.active.empty()) step.largest_push = all.tail(all.size() - rows).cwiseAbs().maxCoeff();
    return step;
  }
  QuadraticProgram elastic;
  const Eigen::MatrixXd scaled = program.scale.asDiagonal() * program.hessian * program.scale.asDiagonal();
  // What is left is measured by what the variables can do to it.
  const double unit = std::max((program.matrix * program.scale.asDiagonal()).cwiseAbs().maxCoeff(), 1e-300);
  const double price =
      std::max(scaled.cwiseAbs().maxCoeff(), 1e-12) * kImbalancePrice * kImbalancePrice / std::pow(unit, 2);
  elastic.hessian = Eigen::MatrixXd::Zero(n + rows, n + rows);
  elastic.hessian.topLeftCorner(n, n) = program.hessian;
  elastic.hessian.bottomRightCorner(rows, rows) = price * Eigen::MatrixXd::Identity(rows, rows);
  elastic.gradient = Eigen::VectorXd::Zero(n + rows);
  elastic.gradient.head(n) = program.gradient;
  elastic.matrix.resize(rows, n + rows);
  elastic.matrix << program.matrix, Eigen::MatrixXd::Identity(rows, rows);
  elastic.right = program.right;
  elastic.normals = Eigen::MatrixXd::Zero(n + rows, program.normals.cols());
  elastic.normals.topRows(n) = program.normals;
  elastic.bounds = program.bounds;
  elastic.scale = Eigen::VectorXd::Constant(n + rows, unit);
  elastic.scale.head(n) = program.scale;
  const QuadraticStep nearest = solveInNullSpace(elastic, deadline);
  step.change = nearest.change.head(n);
  step.multipliers = Eigen::VectorXd::Zero(rows);
  return step;
}

}  // namespace cdpr_kinetostatics
