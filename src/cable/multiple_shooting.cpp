#include "cable/multiple_shooting.h"

#include <Eigen/Jacobi>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "cable/catenary.h"

namespace cdpr_kinetostatics {
namespace {

// Steps may be kept while they make up to so many times the error that was asked of them.
constexpr double kLargestStepError = 4.0;
// A determinant of less than this share of its terms is zero.
constexpr double kRounding = 1e-15;
// A force that turns farther has hardly a direction [rad].
constexpr double kLargestTurn = 0.5;

Eigen::Vector2d feedback(const ShotState& state) { return {state.alpha, state.moment}; }

}  // namespace

void MultipleShooting::setReference() {
  const double t_a = force_.norm();
  const double t_b = std::hypot(force_.x(), force_.y() - cable_.weight * length_);
  reference_force_ = std::max({t_a, t_b, bucklingForce()});
  reference_length_ = std::sqrt(cable_.bending_stiffness / reference_force_);
  reference_moment_ = reference_force_ * reference_length_;
}

double MultipleShooting::bucklingForce() const { return cable_.bending_stiffness * std::pow(M_PI / length_, 2); }

ShotParameters MultipleShooting::parameters() const {
  return {force_.x() / reference_force_, force_.y() / reference_force_,
          cable_.weight * reference_length_ / reference_force_, reference_force_ / cable_.axial_stiffness};
}

bool MultipleShooting::linearise(bool adapt) {
  if (adapt && !meshFits()) replaceMesh(Middle::kQuiet);
  if (tooManySegments()) return false;
  if (!integrate(adapt)) return false;
  if (adapt) grid_length_ = length_;
  return eliminate();
}

bool MultipleShooting::stepsFit() { return step_error_ <= kLargestStepError && meshFits(); }

bool MultipleShooting::integrate(bool adapt) {
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  const double grid_scale = length_ / grid_length_;
  step_error_ = 0.0;
  for (Segment& segment : segments_) {
    if (segment.quiet) continue;
    const double t0 = segment.begin * span;
    const double t1 = segment.end * span;
    const ShotState start{segment.node.x(), segment.node.y(), 0.0, 0.0};
    const bool shot = adapt ? shootAdaptive(p, t0, t1, start, shot_tolerance_, &segment.grid, &segment.shot)
                            : shootOnGrid(p, t0, start, segment.grid, grid_scale, &segment.shot);
    work_ += segment.shot.work;
    if (!shot) return false;
    step_error_ = std::max({step_error_, segment.shot.alpha_error / shot_tolerance_.alpha,
                            segment.shot.moment_error / shot_tolerance_.moment});
    segment.begin_derivative = shotDerivative(p, t0, start);
    segment.end_derivative = shotDerivative(p, t1, segment.shot.end);
  }
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    if (segments_[k].quiet) evaluateMiddle(k);
  }
  return true;
}

void MultipleShooting::evaluateModes(std::size_t k) {
  Segment& segment = segments_[k];
  const double span = length_ / reference_length_;
  segment.slow_begin = slowState(parameters(), segment.begin * span, slow_order_);
  segment.slow_end = slowState(parameters(), segment.end * span, slow_order_);
  segment.shot.end.alpha = node(k + 1).x();
  segment.shot.end.moment = node(k + 1).y();
}

void MultipleShooting::evaluateMiddle(std::size_t k) {
  evaluateModes(k);
  Segment& segment = segments_[k];
  const double span = length_ / reference_length_;
  segment.slow_stretch = slowStretch(parameters(), segment.begin * span, segment.end * span, slow_order_);
  const Eigen::Vector2d along = segment.slow_stretch.displacement +
                                segment.slow_begin.ahead * (segment.node.x() - segment.slow_begin.alpha) +
                                segment.slow_end.behind * (segment.shot.end.alpha - segment.slow_end.alpha);
  segment.shot.end.x = along.x();
  segment.shot.end.y = along.y();
}

// d(state at the segment's end)/dl beside that of its node: the segment's ends are fixed shares of the length.
Eigen::Vector4d MultipleShooting::lengthDerivative(const Segment& segment) {
  const ShotState& b = segment.begin_derivative;
  const ShotState& e = segment.end_derivative;
  const Eigen::Vector4d begin =
      segment.shot.sensitivity.leftCols<2>() * feedback(b) + Eigen::Vector4d(0.0, 0.0, b.x, b.y);
  return Eigen::Vector4d(e.alpha, e.moment, e.x, e.y) * segment.end - begin * segment.begin;
}

// Node k obeys one condition, at A that the moment vanishes, which the segments carry along the cable. With
// what the segment says of its two nodes, dz_k is eliminated, and a condition on node k+1 is left. At B the
// moment vanishes again, which closes the chain.
bool MultipleShooting::eliminate() {
  Condition condition;
  condition.row << 0.0, 1.0;
  condition.right << -segments_.front().node.y(), 0.0, 0.0, 0.0;
  moment_defect_ = std::max(std::abs(segments_.front().node.y()), std::abs(last_node_.y()));
  variation_ << 1.0, 0.0;
  focal_points_ = 0;
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    Segment& segment = segments_[k];
    condition =
        segment.quiet ? joinMiddle(condition, node(k + 1), &segment) : joinShot(condition, node(k + 1), &segment);
    variation_.normalize();
  }
  if (variation_.x() * variation_.y() < 0.0) ++focal_points_;

  if (std::abs(condition.row.x()) < 1e-14) return false;
  last_change_.row(1) << -last_node_.y(), 0.0, 0.0, 0.0;
  last_change_.row(0) = (condition.right - condition.row.y() * last_change_.row(1)) / condition.row.x();

  Affine position = Affine::Zero();
  const Affine* next = &last_change_;
  for (std::size_t k = segments_.size(); k-- > 0;) {
    Segment& segment = segments_[k];
    segment.change = segment.triangle.triangularView<Eigen::Upper>().solve(segment.right - segment.coupling * *next);
    position += displacement(segment, *next);
    next = &segment.change;
  }
  end_.position = reference_length_ * position.col(0);
  end_.jacobian.leftCols<2>() = reference_length_ / reference_force_ * position.middleCols<2>(1);
  end_.jacobian.col(2) = position.col(3);
  return position.allFinite();
}

// A dz_k - dz_(k+1) = c: orthogonal transformations, which do not let the growing mode swamp the other.
MultipleShooting::Condition MultipleShooting::joinShot(const Condition& at_begin, const Eigen::Vector2d& next,
                                                       Segment* segment) {
  const Eigen::Vector2d defect = feedback(segment->shot.end) - next;
  moment_defect_ = std::max(moment_defect_, std::abs(defect.y()));
  double before = variation_.x();
  for (const Eigen::Vector2d& turning : segment->shot.turning) {
    const double now = turning.dot(variation_);
    if (before * now < 0.0) ++focal_points_;
    before = now;
  }
  variation_ = segment->shot.sensitivity.topLeftCorner<2, 2>() * variation_;

  Eigen::Matrix<double, 3, 8> rows;
  rows.row(0) << at_begin.row, 0.0, 0.0, at_begin.right;
  rows.bottomRows<2>() << segment->shot.sensitivity.topLeftCorner<2, 2>(), -Eigen::Matrix2d::Identity(), -defect,
      -segment->shot.sensitivity.topRightCorner<2, 2>(), -lengthDerivative(*segment).head<2>();
  Eigen::JacobiRotation<double> rotation;
  for (const auto& [column, pivot, other] : {std::tuple{0, 0, 1}, std::tuple{0, 0, 2}, std::tuple{1, 1, 2}}) {
    rotation.makeGivens(rows(pivot, column), rows(other, column));
    rows.applyOnTheLeft(pivot, other, rotation.adjoint());
  }
  segment->triangle = rows.topLeftCorner<2, 2>();
  segment->coupling = rows.block<2, 2>(0, 2);
  segment->right = rows.topRightCorner<2, 4>();
  const double scale = 1.0 / rows.block<1, 2>(2, 2).norm();
  return {scale * rows.block<1, 2>(2, 2), scale * rows.bottomRightCorner<1, 4>()};
}

// The nodes at the ends of the middle do not know of each other: the growing mode is absent at its beginning,
// the decaying one at its end.
MultipleShooting::Condition MultipleShooting::joinMiddle(const Condition& at_begin, const Eigen::Vector2d& next,
                                                         Segment* segment) {
  const auto absent = [this](const SlowState& slow, double rho, double share, const Eigen::Vector2d& z) {
    Condition condition;
    condition.row << rho, 1.0;
    const double departure = z.x() - slow.alpha;
    const double along = rho > 0.0 ? 1.0 : -1.0;
    condition.right << -rho * departure - (z.y() - slow.moment),
        condition.row * slow.derivative - along * departure * slow.rateDerivative();
    condition.right.w() *= share;
    moment_defect_ = std::max(moment_defect_, std::abs(condition.right.x()));
    const double scale = 1.0 / condition.row.norm();
    condition.row *= scale;
    condition.right *= scale;
    return condition;
  };
  const Condition growing = absent(segment->slow_begin, segment->slow_begin.decay, segment->begin, segment->node);
  const double sign = growing.row.dot(variation_) < 0.0 ? -1.0 : 1.0;
  if (sign * variation_.x() < 0.0) ++focal_points_;
  variation_ << sign, sign * segment->slow_end.growth;

  Eigen::Matrix<double, 2, 6> rows;
  rows << at_begin.row, at_begin.right, growing.row, growing.right;
  Eigen::JacobiRotation<double> rotation;
  rotation.makeGivens(rows(0, 0), rows(1, 0));
  rows.applyOnTheLeft(0, 1, rotation.adjoint());
  segment->triangle = rows.leftCols<2>();
  segment->coupling.setZero();
  segment->right = rows.rightCols<4>();
  return absent(segment->slow_end, -segment->slow_end.growth, segment->end, next);
}

// The segment's share of (x, y), given what the node at its end does.
MultipleShooting::Affine MultipleShooting::displacement(const Segment& segment, const Affine& next_change) const {
  Affine result;
  if (segment.quiet) {
    const auto departure = [](const SlowState& slow, const Affine& change, double share) {
      Eigen::RowVector4d angle = change.row(0);
      angle.tail<3>() -=
          Eigen::RowVector3d(slow.derivative(0, 0), slow.derivative(0, 1), share * slow.derivative(0, 2));
      return angle;
    };
    const SlowState& begin = segment.slow_begin;
    const SlowState& end = segment.slow_end;
    const Eigen::Matrix<double, 2, 3> ahead = (segment.node.x() - begin.alpha) * begin.shiftDerivative(begin.ahead);
    const Eigen::Matrix<double, 2, 3> behind = (segment.shot.end.alpha - end.alpha) * end.shiftDerivative(end.behind);
    result = begin.ahead * departure(begin, segment.change, segment.begin) +
             end.behind * departure(end, next_change, segment.end);
    result.middleCols<2>(1) +=
        segment.slow_stretch.derivative.leftCols<2>() + ahead.leftCols<2>() + behind.leftCols<2>();
    result.col(3) += (segment.slow_stretch.derivative.col(2) + ahead.col(2)) * segment.begin +
                     (segment.slow_stretch.derivative.col(3) + behind.col(2)) * segment.end;
  } else {
    result = segment.shot.sensitivity.bottomLeftCorner<2, 2>() * segment.change;
    result.middleCols<2>(1) += segment.shot.sensitivity.bottomRightCorner<2, 2>();
    result.col(3) += lengthDerivative(segment).tail<2>();
  }
  result.col(0) += Eigen::Vector2d(segment.shot.end.x, segment.shot.end.y);
  return result;
}

Eigen::Vector4d MultipleShooting::factors(const Eigen::Vector3d& change) const {
  return {1.0, change.x() / reference_force_, change.y() / reference_force_, change.z() / reference_length_};
}

double MultipleShooting::angleChange(const Eigen::Vector3d& change) const {
  const Eigen::Vector4d by = factors(change);
  double largest = std::abs(last_change_.row(0).dot(by));
  for (const Segment& segment : segments_) largest = std::max(largest, std::abs(segment.change.row(0).dot(by)));
  return largest;
}

void MultipleShooting::step(const Eigen::Vector3d& change, double damping) {
  move(damping * factors(change), damping * change);
}

// Nodes turn with the force along the chord, (H, V - q L/2), as a light cable does: its angle and its size are what
// they follow, not its components, whose second order would stretch a stiff cable.
void MultipleShooting::follow(const Eigen::Vector3d& change) {
  const Eigen::Vector2d weight_change(0.0, 0.5 * cable_.weight * change.z());
  const Eigen::Vector2d old_force(force_.x(), force_.y() - 0.5 * cable_.weight * length_);
  const Eigen::Vector2d new_force = old_force + change.head<2>() - weight_change;
  const Eigen::Vector2d across(-old_force.y(), old_force.x());
  const double turn = std::atan2(across.dot(new_force), old_force.dot(new_force));
  Eigen::Vector3d followed = change;
  if (std::abs(turn) < kLargestTurn && old_force.norm() > 0.0) {
    followed.head<2>() = weight_change + (new_force.norm() / old_force.norm() - 1.0) * old_force + turn * across;
  }
  work_ = {};
  Eigen::Vector4d by = factors(followed);
  by[0] = 0.0;
  move(by, change);
}

void MultipleShooting::move(const Eigen::Vector4d& factors, const Eigen::Vector3d& change) {
  for (Segment& segment : segments_) segment.node += segment.change * factors;
  last_node_ += last_change_ * factors;
  force_ += change.head<2>();
  length_ += change.z();
  // What is left of the end's modes in the middle is a small difference: both sides of it must have moved.
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    if (segments_[k].quiet) evaluateModes(k);
  }
}

bool MultipleShooting::stable() const {
  // Compliance of the end point against the force (H, q L - V) that acts on it.
  const double xx = end_.jacobian(0, 0);
  const double ww = -end_.jacobian(1, 1);
  const double xw = 0.5 * (end_.jacobian(1, 0) - end_.jacobian(0, 1));
  const double determinant = xx * ww - xw * xw;
  const bool opposite = determinant < -kRounding * (xx * xx + ww * ww);
  const int negative = opposite ? 1 : xx + ww < 0.0 ? 2 : 0;
  return focal_points_ == negative;
}

void MultipleShooting::restore(const MultipleShooting& earlier) {
  const IntegrationWork work = work_;
  *this = earlier;
  work_ = work;
}

}  // namespace cdpr_kinetostatics
