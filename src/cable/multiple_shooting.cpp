#include "cdpr_kinetostatics/cable/multiple_shooting.h"

#include <Eigen/Jacobi>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "cdpr_kinetostatics/cable/catenary.h"

namespace cdpr_kinetostatics {
namespace {

// A segment spans at most this many local bending layers, and this much of the catenary's turning angle:
// beyond about 4 layers Newton's method starts to fail.
constexpr double kLayersPerSegment = 3.0;
constexpr double kAnglePerSegment = 1.0;  // [rad]

// More segments than this are refused: they would take a second and 100 MB.
constexpr int kMaxSegments = 100000;

// Share of the tolerance that one integration step may use up.
constexpr double kStepShare = 0.1;

// cosh(a)/sinh(b) and sinh(a)/sinh(b) for 0 <= a <= b, without overflow.
double coshOverSinh(double a, double b) { return (std::exp(a - b) + std::exp(-a - b)) / -std::expm1(-2.0 * b); }
double sinhOverSinh(double a, double b) { return (std::exp(a - b) - std::exp(-a - b)) / -std::expm1(-2.0 * b); }

Eigen::Vector2d feedback(const ShotState& state) { return {state.alpha, state.moment}; }

}  // namespace

void MultipleShooting::begin(const CableProperties& cable, double length, const Eigen::Vector2d& force,
                             double tolerance) {
  cable_ = cable;
  tolerance_ = tolerance;
  length_ = length;
  grid_length_ = length;
  force_ = force;
  setReference();
  placeSegments();
}

void MultipleShooting::start(const CableProperties& cable, double length, double horizontal_force,
                             double vertical_force_a, double tolerance) {
  begin(cable, length, {horizontal_force, vertical_force_a}, tolerance);
  startNodes();
}

void MultipleShooting::startStraight(const CableProperties& cable, double length, double x, double w,
                                     double tolerance) {
  const double chord = std::hypot(x, w);
  const double tension = cable.axial_stiffness * (chord / length - 1.0);
  begin(cable, length, {tension * x / chord, 0.5 * cable.weight * length - tension * w / chord}, tolerance);
  for (Segment& segment : segments_) segment.node << std::atan2(w, x), 0.0;
  last_node_ << std::atan2(w, x), 0.0;
  shot_tolerance_.alpha = shot_tolerance_.moment = kStepShare * tolerance_;
}

std::optional<double> MultipleShooting::startFromAngle(const CableProperties& cable, double length,
                                                       double horizontal_force, double vertical_force_a, double angle,
                                                       double tolerance) {
  begin(cable, length, {horizontal_force, vertical_force_a}, tolerance);
  shot_tolerance_.alpha = shot_tolerance_.moment = kStepShare * tolerance_;
  const double span = length_ / reference_length_;
  ShotState state{angle, 0.0, 0.0, 0.0};
  for (Segment& segment : segments_) {
    segment.node << state.alpha, state.moment;
    if (!shootAdaptive(parameters(), segment.begin * span, segment.end * span, state, shot_tolerance_, &segment.grid,
                       &segment.shot)) {
      return std::nullopt;
    }
    state = {segment.shot.end.alpha, segment.shot.end.moment, 0.0, 0.0};
  }
  last_node_ << state.alpha, 0.0;
  return state.moment;
}

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

// Segments end where the integral of (local layers, turning angle) reaches equal shares.
void MultipleShooting::placeSegments() {
  constexpr int kSamples = 128;
  const double h = force_.x();
  const double angle_a = catenaryAngle(cable_, h, force_.y(), 0.0);
  const double ds = length_ / kSamples;
  std::array<double, kSamples + 1> share{};
  double layers = 0.0;
  for (int i = 1; i <= kSamples; ++i) {
    const double t_middle = std::hypot(h, cable_.weight * (i - 0.5) * ds - force_.y());
    layers += std::sqrt(t_middle / cable_.bending_stiffness) * ds;
    share[i] = layers / kLayersPerSegment +
               std::abs(catenaryAngle(cable_, h, force_.y(), i * ds) - angle_a) / kAnglePerSegment;
  }
  const int count = static_cast<int>(std::clamp(std::ceil(share[kSamples]), 1.0, kMaxSegments + 1.0));
  segments_.resize(count);
  int sample = 1;
  double begin = 0.0;
  for (int k = 0; k < count; ++k) {
    const double target = share[kSamples] * (k + 1) / count;
    while (sample < kSamples && share[sample] < target) ++sample;
    const double width = share[sample] - share[sample - 1];
    const double inside = width > 0.0 ? (target - share[sample - 1]) / width : 1.0;
    const double end = k == count - 1 ? 1.0 : (sample - 1 + inside) / kSamples;
    segments_[k].begin = begin;
    segments_[k].end = end;
    segments_[k].grid.clear();
    begin = end;
  }
}

// Catenary plus the bending layers of its two ends, which bring the moment to zero there.
void MultipleShooting::startNodes() {
  const double h = force_.x();
  const auto tension = [&](double s) { return std::hypot(h, cable_.weight * s - force_.y()); };
  const auto turning = [&](double s) { return cable_.weight * h / std::pow(tension(s), 2); };
  const auto layers = [&](double s) { return std::sqrt(tension(s) / cable_.bending_stiffness); };
  const double kappa_a = layers(0.0);
  const double kappa_b = layers(length_);
  const double turn_a = turning(0.0);
  const double turn_b = turning(length_);
  const auto node = [&](double s) {
    const double to_b = length_ - s;
    const double angle = catenaryAngle(cable_, h, force_.y(), s) +
                         turn_a / kappa_a * coshOverSinh(kappa_a * to_b, kappa_a * length_) -
                         turn_b / kappa_b * coshOverSinh(kappa_b * s, kappa_b * length_);
    const double turn = turning(s) - turn_a * sinhOverSinh(kappa_a * to_b, kappa_a * length_) -
                        turn_b * sinhOverSinh(kappa_b * s, kappa_b * length_);
    return Eigen::Vector2d(angle, turn * reference_length_);
  };
  for (Segment& segment : segments_) segment.node = node(segment.begin * length_);
  last_node_ = node(length_);
  segments_.front().node.y() = 0.0;
  last_node_.y() = 0.0;
  const double turned =
      std::abs(catenaryAngle(cable_, h, force_.y(), length_) - catenaryAngle(cable_, h, force_.y(), 0.0));
  shot_tolerance_.alpha = kStepShare * tolerance_ * std::clamp(turned, 1e-6, 1.0);
  shot_tolerance_.moment = shot_tolerance_.alpha;
}

void MultipleShooting::changeProperties(const CableProperties& cable) {
  const double before = reference_length_;
  cable_ = cable;
  setReference();
  for (Segment& segment : segments_) {
    segment.node.y() *= reference_length_ / before;
    segment.grid.clear();
  }
  shot_tolerance_.alpha = shot_tolerance_.moment = kStepShare * tolerance_;
}

bool MultipleShooting::linearise(bool adapt) {
  if (segments() > kMaxSegments) return false;
  const ShotParameters p = parameters();
  const double span = length_ / reference_length_;
  const double grid_scale = length_ / grid_length_;
  for (Segment& segment : segments_) {
    const double t0 = segment.begin * span;
    const double t1 = segment.end * span;
    const ShotState start{segment.node.x(), segment.node.y(), 0.0, 0.0};
    const bool shot = adapt ? shootAdaptive(p, t0, t1, start, shot_tolerance_, &segment.grid, &segment.shot)
                            : shootOnGrid(p, t0, start, segment.grid, grid_scale, &segment.shot);
    if (!shot) return false;
    segment.begin_derivative = shotDerivative(p, t0, start);
    segment.end_derivative = shotDerivative(p, t1, segment.shot.end);
  }
  if (adapt) grid_length_ = length_;
  return eliminate();
}

// Node k obeys one row (row . dz_k = right), the moment condition at A carried along the cable. With the
// two rows of the segment, A dz_k - dz_(k+1) = c, orthogonal transformations eliminate dz_k and leave the
// row of node k+1. At B the moment condition closes the chain.
bool MultipleShooting::eliminate() {
  Eigen::Matrix<double, 1, 2> row(0.0, 1.0);
  Eigen::Matrix<double, 1, 4> row_right;
  row_right << -segments_.front().node.y(), 0.0, 0.0, 0.0;
  angle_defect_ = 0.0;
  moment_defect_ = std::max(std::abs(segments_.front().node.y()), std::abs(last_node_.y()));
  Eigen::Vector2d variation(1.0, 0.0);
  focal_points_ = 0;

  const auto lengthDerivative = [](const Segment& segment) {
    const ShotState& b = segment.begin_derivative;
    const ShotState& e = segment.end_derivative;
    const Eigen::Vector4d begin =
        segment.shot.sensitivity.leftCols<2>() * feedback(b) + Eigen::Vector4d(0.0, 0.0, b.x, b.w);
    return Eigen::Vector4d(Eigen::Vector4d(e.alpha, e.moment, e.x, e.w) * segment.end - begin * segment.begin);
  };

  for (std::size_t k = 0; k < segments_.size(); ++k) {
    Segment& segment = segments_[k];
    const Eigen::Vector2d& next = k + 1 < segments_.size() ? segments_[k + 1].node : last_node_;
    const Eigen::Vector2d defect = feedback(segment.shot.end) - next;
    angle_defect_ = std::max(angle_defect_, std::abs(defect.x()));
    moment_defect_ = std::max(moment_defect_, std::abs(defect.y()));

    Eigen::Matrix<double, 3, 8> rows;
    rows.row(0) << row, 0.0, 0.0, row_right;
    rows.bottomRows<2>() << segment.shot.sensitivity.topLeftCorner<2, 2>(), -Eigen::Matrix2d::Identity(), -defect,
        -segment.shot.sensitivity.topRightCorner<2, 2>(), -lengthDerivative(segment).head<2>();
    Eigen::JacobiRotation<double> rotation;
    for (const auto& [column, pivot, other] : {std::tuple{0, 0, 1}, std::tuple{0, 0, 2}, std::tuple{1, 1, 2}}) {
      rotation.makeGivens(rows(pivot, column), rows(other, column));
      rows.applyOnTheLeft(pivot, other, rotation.adjoint());
    }
    segment.triangle = rows.topLeftCorner<2, 2>();
    segment.coupling = rows.block<2, 2>(0, 2);
    segment.right = rows.topRightCorner<2, 4>();
    const double scale = 1.0 / rows.block<1, 2>(2, 2).norm();
    row = scale * rows.block<1, 2>(2, 2);
    row_right = scale * rows.bottomRightCorner<1, 4>();

    double before = variation.x();
    for (const Eigen::Vector2d& turning : segment.shot.turning) {
      const double now = turning.dot(variation);
      if (before * now < 0.0) ++focal_points_;
      before = now;
    }
    variation = segment.shot.sensitivity.topLeftCorner<2, 2>() * variation;
    variation.normalize();
  }
  if (variation.x() * variation.y() < 0.0) ++focal_points_;

  if (std::abs(row.x()) < 1e-14) return false;
  last_change_.row(1) << -last_node_.y(), 0.0, 0.0, 0.0;
  last_change_.row(0) = (row_right - row.y() * last_change_.row(1)) / row.x();

  Affine position = Affine::Zero();
  const Affine* next = &last_change_;
  for (std::size_t k = segments_.size(); k-- > 0;) {
    Segment& segment = segments_[k];
    segment.change = segment.triangle.triangularView<Eigen::Upper>().solve(segment.right - segment.coupling * *next);
    next = &segment.change;
    position += segment.shot.sensitivity.bottomLeftCorner<2, 2>() * segment.change;
    position.col(0) += Eigen::Vector2d(segment.shot.end.x, segment.shot.end.w);
    position.middleCols<2>(1) += segment.shot.sensitivity.bottomRightCorner<2, 2>();
    position.col(3) += lengthDerivative(segment).tail<2>();
  }
  end_.position = reference_length_ * position.col(0);
  end_.jacobian.leftCols<2>() = reference_length_ / reference_force_ * position.middleCols<2>(1);
  end_.jacobian.col(2) = position.col(3);
  return position.allFinite();
}

Eigen::Vector2d MultipleShooting::nodeChange(const Affine& change, const Eigen::Vector3d& outer, double damping) const {
  const Eigen::Vector4d factors(1.0, outer.x() / reference_force_, outer.y() / reference_force_,
                                outer.z() / reference_length_);
  return damping * (change * factors);
}

double MultipleShooting::angleChange(const Eigen::Vector3d& change) const {
  double largest = std::abs(nodeChange(last_change_, change, 1.0).x());
  for (const Segment& segment : segments_) {
    largest = std::max(largest, std::abs(nodeChange(segment.change, change, 1.0).x()));
  }
  return largest;
}

void MultipleShooting::step(const Eigen::Vector3d& change, double damping) {
  for (Segment& segment : segments_) segment.node += nodeChange(segment.change, change, damping);
  last_node_ += nodeChange(last_change_, change, damping);
  force_ += damping * change.head<2>();
  length_ += damping * change.z();
}

bool MultipleShooting::stable() const {
  // Compliance of the end point against the force (H, q L - V) that acts on it.
  const double xx = end_.jacobian(0, 0);
  const double ww = -end_.jacobian(1, 1);
  const double xw = 0.5 * (end_.jacobian(1, 0) - end_.jacobian(0, 1));
  const double determinant = xx * ww - xw * xw;
  const int negative = determinant < 0.0 ? 1 : xx + ww < 0.0 ? 2 : 0;
  return focal_points_ == negative;
}

double MultipleShooting::areaBelowChord() const {
  double area = 0.0;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  for (const Segment& segment : segments_) {
    const Eigen::Vector2d along(segment.shot.end.x, segment.shot.end.w);
    const Eigen::Vector2d to = from + along;
    const double slope = std::atan2(along.y(), along.x());
    area +=
        0.5 * (from.x() * to.y() - from.y() * to.x()) +
        along.squaredNorm() / 12.0 * (std::sin(segment.shot.end.alpha - slope) - std::sin(segment.node.x() - slope));
    from = to;
  }
  return area * reference_length_ * reference_length_;
}

}  // namespace cdpr_kinetostatics
