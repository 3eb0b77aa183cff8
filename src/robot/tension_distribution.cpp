#include "cdpr_kinetostatics/robot/tension_distribution.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/nearest_in_polytope.h"
#include "robot/null_space.h"

namespace cdpr_kinetostatics {
namespace {

// Accepted violation of a limit, relative to the scaled variables' size.
constexpr double kLimitTolerance = 1e-12;

// Least square of the ratio of the smallest to the largest diagonal element in the Cholesky factor of the matrix times
// its transpose: it is the reciprocal condition number of that product to about two digits, at a small part of the
// cost. Above 1e-8, the solution by the product is as exact as the one by singular values.
constexpr double kRankOfSquare = 1e-6;

// Weight of the tensions' norm beside that of the imbalance, both relative.
constexpr double kLeastNorm = 1e-8;

// Price of what is left of the wrench where the limits cannot be met, relative to the tensions' own weight: high enough
// for as little as possible to be left, low enough for the digits of a double to hold both.
constexpr double kImbalancePrice = 1e4;

// Of a feasible distribution: gradient = matrix^T multipliers where no limit is reached.
void findMultipliers(const TensionProblem& problem, TensionDistribution* distribution) {
  Eigen::VectorXd weight = problem.weight;
  for (const std::vector<int>* limits : {&distribution->at_lower, &distribution->at_upper}) {
    for (const int i : *limits) weight(i) = 0.0;
  }
  // Each equation divided by its weight: those at limits drop out.
  const Eigen::VectorXd compliance =
      problem.weight.cwiseInverse().cwiseProduct((weight.array() > 0.0).cast<double>().matrix());
  const Eigen::VectorXd right = weight.cwiseProduct(distribution->tensions - problem.preferred);
  // Each column by its own size: forces and moments are not to be compared.
  Eigen::MatrixXd scaled = compliance.asDiagonal() * problem.matrix.transpose();
  const Eigen::VectorXd sizes = scaled.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
  scaled = scaled * sizes.cwiseInverse().asDiagonal();
  distribution->multipliers = scaled.completeOrthogonalDecomposition().solve(right).cwiseQuotient(sizes);
  distribution->largest_push = (problem.weight.cwiseAbs2().cwiseProduct(distribution->tensions - problem.preferred) -
                                problem.matrix.transpose() * distribution->multipliers)
                                   .cwiseAbs()
                                   .maxCoeff();
}

TensionDistribution distributeExactly(const TensionProblem& problem, SolveLimits::Clock::time_point deadline) {
  const Eigen::Index n = problem.preferred.size();
  const Eigen::VectorXd inverse_weight = problem.weight.cwiseInverse();
  const Eigen::VectorXd preferred = problem.weight.cwiseProduct(problem.preferred);

  // y = weight t: particular solution plus null space.
  const NullSpace space = nullSpace(problem.matrix * inverse_weight.asDiagonal(), problem.wrench);
  const Eigen::VectorXd& particular = space.particular;
  const Eigen::MatrixXd& null = space.directions;

  TensionDistribution distribution;
  distribution.imbalance = space.imbalance;

  std::vector<int> cable;  // of each constraint; upper limits as -1 - cable
  std::vector<double> bound;
  const double scale = std::max(particular.cwiseAbs().maxCoeff(), preferred.cwiseAbs().maxCoeff());
  Eigen::MatrixXd normals(null.cols(), 2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const double sign : {1.0, -1.0}) {
      const double limit = problem.weight(i) * (sign > 0.0 ? problem.lower(i) : problem.upper(i));
      if (!std::isfinite(limit)) continue;
      normals.col(static_cast<Eigen::Index>(cable.size())) = sign * null.row(i).transpose();
      bound.push_back(sign * (limit - particular(i)));
      cable.push_back(static_cast<int>(sign > 0.0 ? i : -1 - i));
    }
  }
  const auto count = static_cast<Eigen::Index>(cable.size());
  const Eigen::VectorXd bounds = Eigen::Map<const Eigen::VectorXd>(bound.data(), count);
  const NearestPoint nearest = nearestInPolytope(null.transpose() * (preferred - particular), normals.leftCols(count),
                                                 bounds, kLimitTolerance * scale, deadline);
  distribution.feasible = nearest.feasible;
  distribution.tensions = inverse_weight.cwiseProduct(particular + null * nearest.x);
  for (const int constraint : nearest.active) {
    const int i = cable[constraint];
    (i >= 0 ? distribution.at_lower : distribution.at_upper).push_back(i >= 0 ? i : -1 - i);
  }
  return distribution;
}

}  // namespace

TensionDistribution distributeTensions(const TensionProblem& problem, SolveLimits::Clock::time_point deadline) {
  TensionDistribution distribution = distributeExactly(problem, deadline);
  if (distribution.feasible) {
    findMultipliers(problem, &distribution);
    return distribution;
  }
  // What is left of the wrench joins the variables, without limits and at a high price.
  const Eigen::Index n = problem.preferred.size();
  const Eigen::Index rows = problem.wrench.size();
  const auto extended = [rows](const Eigen::VectorXd& values, double more) {
    Eigen::VectorXd longer = Eigen::VectorXd::Constant(values.size() + rows, more);
    longer.head(values.size()) = values;
    return longer;
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  TensionProblem elastic;
  elastic.matrix.resize(rows, n + rows);
  elastic.matrix << problem.matrix, Eigen::MatrixXd::Identity(rows, rows);
  elastic.wrench = problem.wrench;
  elastic.preferred = extended(problem.preferred, 0.0);
  elastic.weight = extended(problem.weight, kImbalancePrice * problem.weight.maxCoeff());
  elastic.lower = extended(problem.lower, -kInfinity);
  elastic.upper = extended(problem.upper, kInfinity);
  distribution.tensions = distributeExactly(elastic, deadline).tensions.head(n);
  return distribution;
}

// Free tensions are preferred + matrix^T multipliers/weight^2, the others their limits.
std::optional<TensionDistribution> distributeAtLimits(const TensionProblem& problem, const std::vector<int>& at_lower,
                                                      const std::vector<int>& at_upper) {
  TensionDistribution distribution;
  Eigen::VectorXd& tensions = distribution.tensions;
  tensions = problem.preferred;
  Eigen::VectorXd compliance = problem.weight.cwiseAbs2().cwiseInverse();
  for (const int i : at_lower) tensions(i) = problem.lower(i);
  for (const int i : at_upper) tensions(i) = problem.upper(i);
  for (const std::vector<int>* limits : {&at_lower, &at_upper}) {
    for (const int i : *limits) compliance(i) = 0.0;
  }
  const Eigen::MatrixXd compliant = problem.matrix * compliance.asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> factor(compliant * problem.matrix.transpose());
  if (factor.info() != Eigen::Success) return std::nullopt;
  const auto diagonal = factor.matrixLLT().diagonal();
  const double ratio = diagonal.minCoeff() / diagonal.maxCoeff();
  if (!(ratio * ratio > kRankOfSquare)) return std::nullopt;
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(problem.wrench.size());
  for (int refinement = 0; refinement < 2; ++refinement) {
    const Eigen::VectorXd correction = factor.solve(problem.wrench - problem.matrix * tensions);
    tensions += compliant.transpose() * correction;
    multipliers += correction;
  }

  if (!((tensions - problem.lower).minCoeff() >= 0.0 && (problem.upper - tensions).minCoeff() >= 0.0)) {
    return std::nullopt;
  }
  // What a limit takes up must push inwards.
  const Eigen::VectorXd pushes =
      problem.weight.cwiseAbs2().cwiseProduct(tensions - problem.preferred) - problem.matrix.transpose() * multipliers;
  const auto pushes_out = [&](int i, double sign) { return !(sign * pushes(i) >= 0.0); };
  for (const int i : at_lower) {
    if (pushes_out(i, 1.0)) return std::nullopt;
  }
  for (const int i : at_upper) {
    if (pushes_out(i, -1.0)) return std::nullopt;
  }
  distribution.feasible = true;
  distribution.multipliers = multipliers;
  distribution.largest_push = pushes.cwiseAbs().maxCoeff();
  distribution.at_lower = at_lower;
  distribution.at_upper = at_upper;
  return distribution;
}

// Lawson and Hanson's active set on |matrix t - wrench|^2 + (small |t|)^2; the second term picks the least norm.
Eigen::VectorXd nonNegativeTensions(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& wrench) {
  const Eigen::Index n = matrix.cols();
  Eigen::MatrixXd system(matrix.rows() + n, n);
  system << matrix, kLeastNorm * matrix.norm() * Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(system.rows());
  right.head(wrench.size()) = wrench;

  Eigen::VectorXd tensions = Eigen::VectorXd::Zero(n);
  std::vector<int> free;
  const double tolerance = 1e-14 * matrix.norm() * wrench.norm();
  for (Eigen::Index i = 0; i < 10 * n; ++i) {
    const Eigen::VectorXd gain = system.transpose() * (right - system * tensions);
    int enters = -1;
    for (int j = 0; j < n; ++j) {
      const bool is_free = std::find(free.begin(), free.end(), j) != free.end();
      if (!is_free && gain(j) > tolerance && (enters < 0 || gain(j) > gain(enters))) enters = j;
    }
    if (enters < 0) break;
    free.push_back(enters);
    while (!free.empty()) {
      const Eigen::VectorXd solution = system(Eigen::all, free).colPivHouseholderQr().solve(right);
      if (solution.minCoeff() > 0.0) {
        tensions.setZero();
        tensions(free) = solution;
        break;
      }
      double share = 1.0;  // as far towards the solution as no tension turns negative
      for (std::size_t j = 0; j < free.size(); ++j) {
        if (solution(j) > 0.0) continue;
        share = std::min(share, tensions(free[j]) / (tensions(free[j]) - solution(j)));
      }
      std::vector<int> kept;
      for (std::size_t j = 0; j < free.size(); ++j) {
        double& tension = tensions(free[j]);
        const bool leaves = solution(j) <= 0.0 && tension / (tension - solution(j)) <= share;
        tension = leaves ? 0.0 : tension + share * (solution(j) - tension);
        if (!leaves) kept.push_back(free[j]);
      }
      free = kept;
    }
  }
  return tensions;
}

}  // namespace cdpr_kinetostatics
