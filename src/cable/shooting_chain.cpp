#include "cable/shooting_chain.h"

#include <Eigen/Jacobi>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace cdpr_kinetostatics {
namespace {

// Smallest coefficient of the last node's angle that can be divided by; its row has the norm 1, and rounding is 1e-16.
constexpr double kSingular = 1e-14;

using Affine = ShootingChain::Affine;

Eigen::Vector2d feedback(const ShotState& state) { return {state.alpha, state.moment}; }

// l_k of (19): d(state at the segment's end)/dl beside that of its node, as its ends are fixed shares of the length.
Eigen::Vector4d lengthDerivative(const ShootingSegment& segment) {
  const ShotState& b = segment.begin_derivative;
  const ShotState& e = segment.end_derivative;
  const Eigen::Vector4d begin =
      segment.shot.sensitivity.leftCols<2>() * feedback(b) + Eigen::Vector4d(0.0, 0.0, b.x, b.y);
  return Eigen::Vector4d(e.alpha, e.moment, e.x, e.y) * segment.end - begin * segment.begin;
}

// What a shot adds to (x, y), given the change of its node.
Affine shotDisplacement(const ShootingSegment& segment, const Affine& change) {
  Affine result = segment.shot.sensitivity.bottomLeftCorner<2, 2>() * change;
  result.middleCols<2>(1) += segment.shot.sensitivity.bottomRightCorner<2, 2>();
  result.col(3) += lengthDerivative(segment).tail<2>();
  return result;
}

// The same of a quiet segment, given the changes of the nodes at both of its ends: the solution without layers, and the
// shift by each end's mode, in proportion to the node's departure from that solution.
Affine quietDisplacement(const ShootingSegment& segment, const Affine& change, const Affine& next_change) {
  const auto departure = [](const SlowState& slow, const Affine& node_change, double share) {
    Eigen::RowVector4d angle = node_change.row(0);
    angle.tail<3>() -= Eigen::RowVector3d(slow.derivative(0, 0), slow.derivative(0, 1), share * slow.derivative(0, 2));
    return angle;
  };
  const SlowState& begin = segment.slow_begin;
  const SlowState& end = segment.slow_end;
  const Eigen::Matrix<double, 2, 3> ahead = (segment.node.x() - begin.alpha) * begin.shiftDerivative(begin.ahead);
  const Eigen::Matrix<double, 2, 3> behind = (segment.shot.end.alpha - end.alpha) * end.shiftDerivative(end.behind);
  Affine result =
      begin.ahead * departure(begin, change, segment.begin) + end.behind * departure(end, next_change, segment.end);
  result.middleCols<2>(1) += segment.slow_stretch.derivative.leftCols<2>() + ahead.leftCols<2>() + behind.leftCols<2>();
  result.col(3) += (segment.slow_stretch.derivative.col(2) + ahead.col(2)) * segment.begin +
                   (segment.slow_stretch.derivative.col(3) + behind.col(2)) * segment.end;
  return result;
}

}  // namespace

// Node k obeys one condition, at A that the moment is the end's, which the segments carry along the cable. With what
// the segment says of its two nodes, dz_k is eliminated, and a condition on node k+1 is left. At B the moment is known
// again, which closes the chain.
bool ShootingChain::eliminate(const SegmentList& segments, const Eigen::Vector2d& last_node,
                              const EndMoments& moments) {
  const double missing_at_a = moments.a - segments.front().node.y();
  const double missing_at_b = moments.b - last_node.y();
  Condition condition;
  condition.row << 0.0, 1.0;
  condition.right << missing_at_a, 0.0, 0.0, 0.0;
  moment_defect_ = std::max(std::abs(missing_at_a), std::abs(missing_at_b));
  if (moments.slides_at_a) {
    variation_ << 0.0, 1.0;
  } else {
    variation_ << 1.0, 0.0;
  }
  focal_points_ = 0;
  links_.resize(segments.size());
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Eigen::Vector2d& next = k + 1 < segments.size() ? segments[k + 1].node : last_node;
    condition = segments[k].quiet ? joinQuiet(condition, segments[k], next, &links_[k])
                                  : joinShot(condition, segments[k], next, &links_[k]);
    variation_.normalize();
  }
  if (variation_.x() * variation_.y() < 0.0) ++focal_points_;

  if (std::abs(condition.row.x()) < kSingular) return false;
  last_change_.row(1) << missing_at_b, 0.0, 0.0, 0.0;
  last_change_.row(0) = (condition.right - condition.row.y() * last_change_.row(1)) / condition.row.x();
  return substituteBack(segments);
}

bool ShootingChain::substituteBack(const SegmentList& segments) {
  end_.setZero();
  const Affine* next = &last_change_;
  for (std::size_t k = segments.size(); k-- > 0;) {
    const ShootingSegment& segment = segments[k];
    Link& link = links_[k];
    link.change = link.triangle.triangularView<Eigen::Upper>().solve(link.right - link.coupling * *next);
    Affine displacement =
        segment.quiet ? quietDisplacement(segment, link.change, *next) : shotDisplacement(segment, link.change);
    displacement.col(0) += Eigen::Vector2d(segment.shot.end.x, segment.shot.end.y);
    end_ += displacement;
    next = &link.change;
  }
  return end_.allFinite();
}

// Zeros of beta in (21) within a shot: its sign is looked at after every step of the integration.
void ShootingChain::countFocalPoints(const ShootingSegment& segment) {
  double before = variation_.x();
  for (const Eigen::Vector2d& turning : segment.shot.turning) {
    const double now = turning.dot(variation_);
    if (before * now < 0.0) ++focal_points_;
    before = now;
  }
  variation_ = segment.shot.sensitivity.topLeftCorner<2, 2>() * variation_;
}

// Two rows of (19), A dz_k - dz_(k+1) = ..., under the condition on dz_k. Orthogonal transformations do not let the
// growing mode swamp the other.
ShootingChain::Condition ShootingChain::joinShot(const Condition& at_begin, const ShootingSegment& segment,
                                                 const Eigen::Vector2d& next, Link* link) {
  const Eigen::Vector2d defect = feedback(segment.shot.end) - next;
  moment_defect_ = std::max(moment_defect_, std::abs(defect.y()));
  countFocalPoints(segment);

  Eigen::Matrix<double, 3, 8> rows;
  rows.row(0) << at_begin.row, 0.0, 0.0, at_begin.right;
  rows.bottomRows<2>() << segment.shot.sensitivity.topLeftCorner<2, 2>(), -Eigen::Matrix2d::Identity(), -defect,
      -segment.shot.sensitivity.topRightCorner<2, 2>(), -lengthDerivative(segment).head<2>();
  Eigen::JacobiRotation<double> rotation;
  for (const auto& [column, pivot, other] : {std::tuple{0, 0, 1}, std::tuple{0, 0, 2}, std::tuple{1, 1, 2}}) {
    rotation.makeGivens(rows(pivot, column), rows(other, column));
    rows.applyOnTheLeft(pivot, other, rotation.adjoint());
  }
  link->triangle = rows.topLeftCorner<2, 2>();
  link->coupling = rows.block<2, 2>(0, 2);
  link->right = rows.topRightCorner<2, 4>();
  const double scale = 1.0 / rows.block<1, 2>(2, 2).norm();
  return {scale * rows.block<1, 2>(2, 2), scale * rows.bottomRightCorner<1, 4>()};
}

// rho (alpha - alpha_slow) + (m - m_slow) = 0 at a node, linearised: without the growing mode for rho = decay, without
// the decaying one for rho = -growth. share is where the node lies on the cable.
ShootingChain::Condition ShootingChain::modeIsAbsent(const SlowState& slow, double rho, double share,
                                                     const Eigen::Vector2d& node) {
  Condition condition;
  condition.row << rho, 1.0;
  const double departure = node.x() - slow.alpha;
  const double along = rho > 0.0 ? 1.0 : -1.0;
  condition.right << -rho * departure - (node.y() - slow.moment),
      condition.row * slow.derivative - along * departure * slow.rateDerivative();
  condition.right.w() *= share;
  moment_defect_ = std::max(moment_defect_, std::abs(condition.right.x()));
  const double scale = 1.0 / condition.row.norm();
  condition.row *= scale;
  condition.right *= scale;
  return condition;
}

// The nodes at the ends of a quiet segment do not know of each other: the growing mode is absent at its beginning, the
// decaying one at its end. Across it a variation grows, so that its sign at the end is that of its growing part.
ShootingChain::Condition ShootingChain::joinQuiet(const Condition& at_begin, const ShootingSegment& segment,
                                                  const Eigen::Vector2d& next, Link* link) {
  const Condition growing = modeIsAbsent(segment.slow_begin, segment.slow_begin.decay, segment.begin, segment.node);
  const double sign = growing.row.dot(variation_) < 0.0 ? -1.0 : 1.0;
  if (sign * variation_.x() < 0.0) ++focal_points_;
  variation_ << sign, sign * segment.slow_end.growth;

  Eigen::Matrix<double, 2, 6> rows;
  rows << at_begin.row, at_begin.right, growing.row, growing.right;
  Eigen::JacobiRotation<double> rotation;
  rotation.makeGivens(rows(0, 0), rows(1, 0));
  rows.applyOnTheLeft(0, 1, rotation.adjoint());
  link->triangle = rows.leftCols<2>();
  link->coupling.setZero();
  link->right = rows.rightCols<4>();
  return modeIsAbsent(segment.slow_end, -segment.slow_end.growth, segment.end, next);
}

double ShootingChain::angleChange(const Eigen::Vector4d& factors) const {
  double largest = std::abs(last_change_.row(0).dot(factors));
  for (const Link& link : links_) largest = std::max(largest, std::abs(link.change.row(0).dot(factors)));
  return largest;
}

}  // namespace cdpr_kinetostatics
