#include "estimation/variance_window.h"

#include <algorithm>
#include <cmath>

#include "estimation/adjustment_statistics.h"

namespace cdpr_kinetostatics {
namespace {

// After so many good messages nothing is left of bad ones before.
constexpr std::size_t kMessages = 10;

// A sum of squares that noise exceeds once in 700 times, in standard deviations of its cubic root.
constexpr double kImprobable = 3.0;

// With less the others do not check the measurements of a kind.
constexpr double kLeastRedundancy = 0.01;

// The variances of the kinds are found to a few per cent.
constexpr int kIterations = 50;

// Upper limit of a chi-square variable over its freedoms, by Wilson and Hilferty: its cubic root is nearly normal.
double noiseLimit(double freedoms) {
  const double variance = 2.0 / (9.0 * freedoms);
  return std::pow(std::max(1.0 - variance, 0.0) + kImprobable * std::sqrt(variance), 3);
}

Eigen::Index kindOf(const Observation& observation) { return static_cast<Eigen::Index>(observation.kind); }

bool contains(const std::vector<LeftOut>& left_out, const Observation& o) {
  return std::any_of(left_out.begin(), left_out.end(),
                     [&](const LeftOut& other) { return isSame(other.observation, o); });
}

// (row, column): the share of a column's variance, summed over its observations, that shows in the squared residuals of
// the row's.
Eigen::Matrix3d shares(const Adjusted& adjusted) {
  const Eigen::MatrixXd range = explainable(adjusted.jacobian);
  const Eigen::MatrixXd residual = Eigen::MatrixXd::Identity(range.rows(), range.rows()) - range * range.transpose();
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  for (const Observation& seen : adjusted.observations) {
    for (const Observation& by : adjusted.observations) {
      sums(kindOf(seen), kindOf(by)) += std::pow(residual(seen.row, by.row), 2);
    }
  }
  return sums;
}

}  // namespace

void VarianceWindow::add(const Candidate& candidate) {
  if (messages_.size() == kMessages) messages_.erase(messages_.begin());
  Message message;
  for (const Observation& o : candidate.adjusted.observations) {
    message.squares(kindOf(o)) += o.residual * o.residual;
    message.redundancy(kindOf(o)) += o.redundancy;
  }
  message.left_out = candidate.left_out;
  messages_.push_back(message);
}

// Of those that are left out alone, the largest of each kind does not count: a single reading may go wrong.
VarianceWindow::Message VarianceWindow::sum() const {
  Message all;
  Eigen::Vector3d largest = Eigen::Vector3d::Zero();
  for (std::size_t m = 0; m < messages_.size(); ++m) {
    all.squares += messages_[m].squares;
    all.redundancy += messages_[m].redundancy;
    if (m + 1 == messages_.size()) break;  // the next message will tell whether the last one's are alone
    for (const LeftOut& one : messages_[m].left_out) {
      const bool before = m > 0 && contains(messages_[m - 1].left_out, one.observation);
      if (before || contains(messages_[m + 1].left_out, one.observation)) continue;
      const Eigen::Index kind = kindOf(one.observation);
      if (largest(kind) > 0.0) all.redundancy(kind) += one.redundancy;
      all.squares(kind) += std::min(one.gain, largest(kind));
      largest(kind) = std::max(one.gain, largest(kind));
    }
  }
  return all;
}

// Expected are squares = shares * variances (docs/theory.md section 5). The variances that bring this about are
// approached by factors, so that they stay positive.
DeviationFactors VarianceWindow::factors(const Candidate& current) const {
  const Message all = sum();
  bool improbable = false;
  for (Eigen::Index g = 0; g < 3; ++g) {
    if (all.redundancy(g) < kLeastRedundancy) continue;
    improbable |= all.squares(g) > all.redundancy(g) * noiseLimit(all.redundancy(g));
  }
  if (!improbable) return {};
  const Eigen::Matrix3d seen = shares(current.adjusted);
  const Eigen::Vector3d by_message = seen.rowwise().sum();
  Eigen::Vector3d variances = Eigen::Vector3d::Ones();
  for (int k = 0; k < kIterations; ++k) {
    const Eigen::Vector3d expected = seen * variances;
    for (Eigen::Index g = 0; g < 3; ++g) {
      if (by_message(g) < kLeastRedundancy || all.redundancy(g) < kLeastRedundancy) continue;
      const double times = all.redundancy(g) / by_message(g);  // as many messages as this one
      variances(g) = std::max(1.0, variances(g) * all.squares(g) / (expected(g) * times));
    }
  }
  const Eigen::Vector3d factors = variances.cwiseSqrt();
  return {factors(0), factors(1), factors(2)};
}

bool isWider(const DeviationFactors& factors) {
  return factors.lengths > 1.0 || factors.tensions > 1.0 || factors.load > 1.0;
}

EstimatorOptions widened(const EstimatorOptions& options, const DeviationFactors& factors) {
  EstimatorOptions wide = options;
  wide.length_stddev *= factors.lengths;
  wide.tension_stddev *= factors.tensions;
  wide.load_stddev *= factors.load;
  return wide;
}

}  // namespace cdpr_kinetostatics
