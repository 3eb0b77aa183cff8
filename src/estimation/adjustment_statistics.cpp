#include "estimation/adjustment_statistics.h"

#include <Eigen/QR>
#include <vector>

namespace cdpr_kinetostatics {
namespace {

// A column of the Jacobian adds to its rank if more than this share of it is new.
constexpr double kRank = 1e-9;

// A component of the load is open if more than this share of its gradient lies where nothing was observed.
constexpr double kOpen = 1e-6;

using Decomposition = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

Eigen::VectorXd inverseNorms(const Eigen::MatrixXd& jacobian) {
  const Eigen::VectorXd norms = jacobian.colwise().norm();
  return (norms.array() > 0.0).select(norms.cwiseInverse(), 1.0);
}

Decomposition decomposed(const Eigen::MatrixXd& scaled) {
  Decomposition decomposition(scaled);
  decomposition.setThreshold(kRank);
  return decomposition;
}

Eigen::MatrixXd rangeOf(const Decomposition& decomposition) {
  return decomposition.householderQ() * Eigen::MatrixXd::Identity(decomposition.rows(), decomposition.rank());
}

void fillRedundancies(const Decomposition& decomposition, Adjusted* adjusted) {
  const Eigen::MatrixXd range = rangeOf(decomposition);
  adjusted->redundancy = -static_cast<int>(range.cols());
  std::vector<Observation> used;
  for (Observation observation : adjusted->observations) {
    if (adjusted->jacobian.row(observation.row).squaredNorm() == 0.0) continue;  // a component that is not known
    observation.redundancy = 1.0 - range.row(observation.row).squaredNorm();
    adjusted->weighted_squares += observation.residual * observation.residual;
    ++adjusted->redundancy;
    used.push_back(observation);
  }
  adjusted->observations = used;
}

// load: by the scaled unknowns. With A P = Q (R1 R2), unknowns outside the rank are those of R2's columns: held, the
// others have the covariance (R1^T R1)^-1; moved, the others follow by -R1^-1 R2.
void fillLoadCovariance(const Eigen::MatrixXd& load, const Decomposition& decomposition, Adjusted* adjusted) {
  const Eigen::Index rank = decomposition.rank();
  const Eigen::MatrixXd permuted = load * decomposition.colsPermutation();
  const Eigen::MatrixXd r = decomposition.matrixR().topRows(rank);
  const Eigen::MatrixXd root = r.leftCols(rank)
                                   .triangularView<Eigen::Upper>()
                                   .transpose()
                                   .solve(permuted.leftCols(rank).transpose())
                                   .transpose();
  const Eigen::MatrixXd open = permuted.rightCols(load.cols() - rank) - root * r.rightCols(load.cols() - rank);
  adjusted->load_covariance = root * root.transpose();
  for (Eigen::Index k = 0; k < load.rows(); ++k) {
    adjusted->load_unknown(k) = open.row(k).norm() > kOpen * load.row(k).norm();
  }
}

}  // namespace

Eigen::MatrixXd explainable(const Eigen::MatrixXd& jacobian) {
  return rangeOf(decomposed(jacobian * inverseNorms(jacobian).asDiagonal()));
}

void analyse(const Eigen::MatrixXd& load, Adjusted* adjusted) {
  const Eigen::MatrixXd& jacobian = adjusted->jacobian;
  const Eigen::Index freedoms = load.rows();
  const Eigen::VectorXd inverse_norms = inverseNorms(jacobian);
  const Eigen::MatrixXd scaled = jacobian * inverse_norms.asDiagonal();
  const Decomposition all = decomposed(scaled);
  fillRedundancies(all, adjusted);
  fillLoadCovariance(load * inverse_norms.asDiagonal(), all, adjusted);

  const Decomposition cables = decomposed(scaled.rightCols(jacobian.cols() - freedoms));
  const Eigen::MatrixXd pose = cables.householderQ().transpose() * jacobian.leftCols(freedoms);
  const Eigen::MatrixXd left = pose.bottomRows(pose.rows() - cables.rank());
  adjusted->information = left.transpose() * left;
}

}  // namespace cdpr_kinetostatics
