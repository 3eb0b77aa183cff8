#include "cdpr_kinetostatics/robot/tension_distribution.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <cmath>

#include "cdpr_kinetostatics/robot/bounded_qp.h"

namespace cdpr_kinetostatics {
namespace {

// Singular values below this share of the largest are zero: the cables cannot act in that direction.
constexpr double kRank = 1e-10;

// Accepted violation of a limit, relative to the scaled variables' size.
constexpr double kLimitTolerance = 1e-12;

}  // namespace

TensionDistribution distributeTensions(const TensionProblem& problem) {
  const Eigen::Index n = problem.preferred.size();
  const Eigen::VectorXd inverse_weight = problem.weight.cwiseInverse();
  const Eigen::VectorXd preferred = problem.weight.cwiseProduct(problem.preferred);

  // y = weight t: particular solution plus null space.
  const Eigen::MatrixXd scaled = problem.matrix * inverse_weight.asDiagonal();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  const Eigen::Index rank = (values.array() > kRank * values(0)).count();
  const Eigen::VectorXd rotated = svd.matrixU().transpose() * problem.wrench;
  const Eigen::VectorXd particular = svd.matrixV().leftCols(rank) * rotated.head(rank).cwiseQuotient(values.head(rank));
  const Eigen::MatrixXd null = svd.matrixV().rightCols(n - rank);

  TensionDistribution distribution;
  distribution.imbalance = rotated.tail(rotated.size() - rank).norm();

  std::vector<int> cable;  // of each constraint; upper limits as -1 - cable
  std::vector<double> bound;
  const double scale = std::max(particular.cwiseAbs().maxCoeff(), preferred.cwiseAbs().maxCoeff());
  Eigen::MatrixXd normals(n - rank, 2 * n);
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
                                                 bounds, kLimitTolerance * scale);
  distribution.feasible = nearest.feasible;
  distribution.tensions = inverse_weight.cwiseProduct(particular + null * nearest.x);
  for (const int constraint : nearest.active) {
    const int i = cable[constraint];
    (i >= 0 ? distribution.at_lower : distribution.at_upper).push_back(i >= 0 ? i : -1 - i);
  }
  return distribution;
}

Eigen::VectorXd nonNegativeTensions(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& wrench) {
  // min |matrix t - wrench|^2 + regularisation |t|^2, t >= 0, as the nearest point in y = L^T t.
  const Eigen::Index n = matrix.cols();
  const double size = matrix.squaredNorm();
  const Eigen::MatrixXd hessian = matrix.transpose() * matrix + 1e-12 * size * Eigen::MatrixXd::Identity(n, n);
  const Eigen::LLT<Eigen::MatrixXd> cholesky(hessian);
  const Eigen::VectorXd x0 = cholesky.matrixL().solve(matrix.transpose() * wrench);
  const Eigen::MatrixXd normals = cholesky.matrixL().solve(Eigen::MatrixXd::Identity(n, n));
  const NearestPoint nearest =
      nearestInPolytope(x0, normals, Eigen::VectorXd::Zero(n), kLimitTolerance * wrench.norm() / std::sqrt(size));
  return cholesky.matrixU().solve(nearest.x).cwiseMax(0.0);
}

}  // namespace cdpr_kinetostatics
