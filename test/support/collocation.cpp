#include "collocation.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "second_variation.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kStages = 6;
constexpr int kMaxIterations = 60;
constexpr int kMaxIntervals = 4000;
constexpr double kLargestTurn = 0.5;  // of a node in one iteration [rad]

// Intervals per end layer and per radian of turn of the force, and in any case.
constexpr double kLayerDensity = 0.8;
constexpr double kTurnDensity = 1.5;
constexpr double kLeastIntervals = 6.0;
constexpr double kFiner = 1.6;   // of the second mesh
constexpr double kFinest = 8.0;  // of the third, for stability alone
// Order 12 forgives intervals that grow with the distance z, in layers, from the end as exp(z/13).
constexpr double kLayerGrowth = 13.0;

// The Gauss rule on [0, 1] and its integrals from 0 to each node.
struct Gauss {
  std::array<double, kStages> node, weight;
  Eigen::Matrix<double, kStages, kStages> integral;
  Eigen::Matrix<double, 1, kStages> to_end;  // weight * integral^-1

  Gauss() {
    std::array<long double, kStages> x, b;
    for (int i = 0; i < kStages; ++i) {
      long double z = std::cos(static_cast<long double>(M_PI) * (i + 0.75L) / (kStages + 0.5L));
      long double slope = 0.0L;
      for (int k = 0; k < 20; ++k) {
        long double p = 1.0L, last = 0.0L;
        for (int n = 1; n <= kStages; ++n) {
          const long double next = ((2 * n - 1) * z * p - (n - 1) * last) / n;
          last = p;
          p = next;
        }
        slope = kStages * (z * p - last) / (z * z - 1.0L);
        z -= p / slope;
      }
      x[kStages - 1 - i] = 0.5L * (1.0L + z);
      b[kStages - 1 - i] = 1.0L / ((1.0L - z * z) * slope * slope);
    }
    for (int i = 0; i < kStages; ++i) {
      node[i] = static_cast<double>(x[i]);
      weight[i] = static_cast<double>(b[i]);
      for (int k = 0; k < kStages; ++k) {
        long double sum = 0.0L;
        for (int j = 0; j < kStages; ++j) {
          long double lagrange = b[j] * x[i];
          for (int n = 0; n < kStages; ++n) {
            if (n != k) lagrange *= (x[i] * x[j] - x[n]) / (x[k] - x[n]);
          }
          sum += lagrange;
        }
        integral(i, k) = static_cast<double>(sum);
      }
    }
    to_end = Eigen::Map<const Eigen::Matrix<double, 1, kStages>>(weight.data()) * integral.inverse();
  }
};

const Gauss& gauss() {
  static const Gauss rule;
  return rule;
}

// Lengths in units of the cable's, forces in those of F0, moments in those of F0 L lambda.
struct Scaled {
  double lambda = 0.0;  // sqrt(EI/F0)/L
  double eps = 0.0;     // F0/EA
  double q = 0.0;       // q L/F0
  Eigen::Vector2d force;
};

// Right-hand side at one point: (alpha', m', x', y') and derivatives with respect to (alpha, m, h, v).
struct Slope {
  Eigen::Vector4d value;
  Eigen::Matrix4d derivative;
  double tension, shear, e;

  Slope(const Scaled& c, double s, const Eigen::Vector2d& y) {
    const double cosine = std::cos(y.x());
    const double sine = std::sin(y.x());
    const double u = c.force.y() - c.q * s;
    tension = c.force.x() * cosine - u * sine;
    shear = c.force.x() * sine + u * cosine;
    e = 1.0 + c.eps * tension;
    const double per_layer = 1.0 / c.lambda;
    const Eigen::RowVector4d de(-c.eps * shear, 0.0, c.eps * cosine, -c.eps * sine);
    value << e * y.y() * per_layer, e * shear * per_layer, e * cosine, e * sine;
    derivative.row(0) = per_layer * (y.y() * de + Eigen::RowVector4d(0.0, e, 0.0, 0.0));
    derivative.row(1) = per_layer * (shear * de + e * Eigen::RowVector4d(tension, 0.0, sine, cosine));
    derivative.row(2) = cosine * de + Eigen::RowVector4d(-e * sine, 0.0, 0.0, 0.0);
    derivative.row(3) = sine * de + Eigen::RowVector4d(e * cosine, 0.0, 0.0, 0.0);
  }
};

// Columns: what multiplies dy at the interval's beginning (2), d(h, v) (2), and the residual (1).
using Columns = Eigen::Matrix<double, Eigen::Dynamic, 5>;

struct Interval {
  double begin = 0.0, width = 0.0;
  Eigen::Vector2d node;                          // at its beginning
  std::array<Eigen::Vector2d, kStages> stage;    // (alpha, m)
  Eigen::Matrix<double, 2 * kStages, 5> stages;  // changes of the stages
  Eigen::Matrix<double, 2, 5> to_next, along;    // change of (alpha, m) at the end; displacement over the interval
};

class Collocation {
 public:
  Collocation(const ClaimedCable& claim, double fineness) : claim_(claim) {
    const double weight = claim.cable.weight * claim.length;
    force_scale_ = std::max({std::hypot(claim.h, claim.v), std::hypot(claim.h, claim.v - weight),
                             claim.cable.bending_stiffness / (claim.length * claim.length)});
    scaled_.lambda = std::sqrt(claim.cable.bending_stiffness / force_scale_) / claim.length;
    scaled_.eps = force_scale_ / claim.cable.axial_stiffness;
    scaled_.q = weight / force_scale_;
    scaled_.force = Eigen::Vector2d(claim.h, claim.v) / force_scale_;
    bend_ = std::cbrt(scaled_.lambda * scaled_.lambda * scaled_.q);
    fineness_ = fineness;
    std::vector<double> breaks{0.0};
    const double bottom = scaled_.q > 0.0 ? scaled_.force.y() / scaled_.q : 0.0;
    if (bottom > 0.0 && bottom < 1.0) breaks.push_back(bottom);
    breaks.push_back(1.0);
    for (std::size_t i = 1; i < breaks.size(); ++i) split(breaks[i - 1], breaks[i], 0);
    last_ = guess(1.0);
    last_.y() = 0.0;
    if (!intervals_.empty()) intervals_.front().node.y() = 0.0;
  }

  int intervals() const { return static_cast<int>(intervals_.size()); }
  int iterations() const { return iterations_; }
  double forceScale() const { return force_scale_; }

  bool solve(Kept kept) {
    if (intervals() > kMaxIntervals) return false;
    const Eigen::Vector2d end = Eigen::Vector2d(claim_.x, claim_.y) / claim_.length;
    double last_size = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMaxIterations; ++i) {
      ++iterations_;
      if (!linearise()) return false;
      Eigen::Vector2d change = Eigen::Vector2d::Zero();
      if (kept == Kept::kEndPoint) change = compliance_.inverse() * (end - end_);
      if (!change.allFinite()) return false;
      const double size = std::max(turn(change), change.norm());
      if (!std::isfinite(size)) return false;
      advance(change, std::min(1.0, kLargestTurn / turn(change)));
      const bool at_rounding = size < 1e-7 && size >= 0.25 * last_size;
      if (size < 1e-14 || at_rounding) return linearise();
      last_size = size;
    }
    return false;
  }

  Eigen::Vector2d force() const { return force_scale_ * scaled_.force; }
  Eigen::Vector2d end() const { return claim_.length * end_; }
  Eigen::Matrix2d compliance() const { return claim_.length / force_scale_ * compliance_; }
  double angleA() const { return intervals_.front().node.x(); }
  double angleB() const { return last_.x(); }

  double areaBelowChord() const {
    double area = 0.0;
    Eigen::Vector2d from = Eigen::Vector2d::Zero();
    for (const Interval& interval : intervals_) {
      std::array<Eigen::Vector2d, kStages> slope;
      for (int j = 0; j < kStages; ++j) slope[j] = at(interval, j).value.tail<2>();
      Eigen::Vector2d next = from;
      for (int j = 0; j < kStages; ++j) {
        Eigen::Vector2d here = from;
        for (int k = 0; k < kStages; ++k) here += interval.width * gauss().integral(j, k) * slope[k];
        area += 0.5 * interval.width * gauss().weight[j] * (here.x() * slope[j].y() - here.y() * slope[j].x());
        next += interval.width * gauss().weight[j] * slope[j];
      }
      from = next;
    }
    return area * claim_.length * claim_.length;
  }

  bool stable() const {
    SecondVariation variation(scaled_.lambda * scaled_.lambda, scaled_.eps);
    for (const Interval& interval : intervals_) {
      variation.add(point(Slope(scaled_, interval.begin, interval.node), interval.begin, interval.node.x()));
      for (int j = 0; j < kStages; ++j) {
        variation.add(point(at(interval, j), interval.begin + gauss().node[j] * interval.width, interval.stage[j].x()));
      }
    }
    variation.add(point(Slope(scaled_, 1.0, last_), 1.0, last_.x()));
    return variation.stableWithEndsHeld();
  }

 private:
  static VariationPoint point(const Slope& slope, double s, double alpha) {
    return {s, alpha, slope.e, slope.tension, slope.shear};
  }

  Slope at(const Interval& interval, int j) const {
    return {scaled_, interval.begin + gauss().node[j] * interval.width, interval.stage[j]};
  }

  double tension(double s) const { return std::hypot(scaled_.force.x(), scaled_.q * s - scaled_.force.y()); }

  // Intervals per unit of length at s.
  double density(double s) const {
    const auto layer = [&](double end) {
      const double at_end = scaled_.lambda / std::sqrt(std::max({tension(end), scaled_.q * bend_, 1e-300}));
      const double distance = std::abs(s - end) / at_end;
      return kLayerDensity / at_end * std::exp(-distance / kLayerGrowth);
    };
    const double turn = scaled_.q / std::max({tension(s), scaled_.q * bend_, 1e-300});
    return fineness_ * (kLeastIntervals + layer(0.0) + layer(1.0) + kTurnDensity * turn);
  }

  void split(double from, double to, int depth) {
    const double middle = 0.5 * (from + to);
    const double most = std::max({density(from), density(middle), density(to)});
    if (depth < 45 && (to - from) * most > 1.0 && intervals() <= kMaxIntervals) {
      split(from, middle, depth + 1);
      split(middle, to, depth + 1);
      return;
    }
    Interval interval;
    interval.begin = from;
    interval.width = to - from;
    interval.node = guess(from);
    for (int j = 0; j < kStages; ++j) interval.stage[j] = guess(from + gauss().node[j] * interval.width);
    intervals_.push_back(interval);
  }

  // (alpha, m) where Newton's method starts.
  Eigen::Vector2d guess(double s) const {
    const std::vector<ProfilePoint>& profile = claim_.profile;
    if (profile.size() < 2) {
      const double h = std::max(scaled_.force.x(), scaled_.q * bend_);
      const double u = scaled_.q * s - scaled_.force.y();
      return {std::atan2(u, h), scaled_.lambda * scaled_.q * h / (h * h + u * u)};
    }
    const double place = s * static_cast<double>(profile.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), profile.size() - 2);
    const double share = place - static_cast<double>(i);
    const double span = 1.0 / static_cast<double>(profile.size() - 1);
    const auto state = [&](const ProfilePoint& p) {
      return Eigen::Vector2d(p.alpha, p.moment / (force_scale_ * claim_.length * scaled_.lambda));
    };
    const auto slope = [&](std::size_t k) -> Eigen::Vector2d {
      return span * Slope(scaled_, static_cast<double>(k) * span, state(profile[k])).value.head<2>();
    };
    const Eigen::Vector2d a = state(profile[i]);
    const Eigen::Vector2d b = state(profile[i + 1]);
    const Eigen::Vector2d da = slope(i) - (b - a);
    const Eigen::Vector2d db = slope(i + 1) - (b - a);
    const Eigen::Vector2d line = a + share * (b - a);
    if (claim_.length * span > claim_.length * scaled_.lambda) return line;  // layers thinner than the profile's steps
    return line + share * (1.0 - share) * ((1.0 - share) * da - share * db);
  }

  // Stages eliminated: what the interval does, given the change of its first node and of the forces.
  void condense(Interval* interval) {
    const Gauss& rule = gauss();
    const double width = interval->width;
    Eigen::Matrix<double, 2 * kStages, 2 * kStages> system;
    Eigen::Matrix<double, 2 * kStages, 5> right;
    std::array<Slope, kStages> slope = {at(*interval, 0), at(*interval, 1), at(*interval, 2),
                                        at(*interval, 3), at(*interval, 4), at(*interval, 5)};
    system.setIdentity();
    for (int j = 0; j < kStages; ++j) {
      Eigen::Matrix<double, 2, 5> row;
      row << Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Zero(), interval->node - interval->stage[j];
      for (int k = 0; k < kStages; ++k) {
        const double factor = width * rule.integral(j, k);
        system.block<2, 2>(2 * j, 2 * k) -= factor * slope[k].derivative.topLeftCorner<2, 2>();
        row.middleCols<2>(2) += factor * slope[k].derivative.topRightCorner<2, 2>();
        row.col(4) += factor * slope[k].value.head<2>();
      }
      right.middleRows<2>(2 * j) = row;
    }
    interval->stages = system.partialPivLu().solve(right);
    interval->to_next.setZero();
    interval->to_next.leftCols<2>().setIdentity();
    interval->to_next.col(4) = interval->node;
    interval->along.setZero();
    for (int j = 0; j < kStages; ++j) {
      Eigen::Matrix<double, 2, 5> stage = interval->stages.middleRows<2>(2 * j);
      const double factor = width * rule.weight[j];
      interval->along += factor * slope[j].derivative.bottomLeftCorner<2, 2>() * stage;
      interval->along.middleCols<2>(2) += factor * slope[j].derivative.bottomRightCorner<2, 2>();
      interval->along.col(4) += factor * slope[j].value.tail<2>();
      stage.col(4) += interval->stage[j] - interval->node;
      stage.leftCols<2>() -= Eigen::Matrix2d::Identity();
      interval->to_next += rule.to_end(j) * stage;
    }
  }

  // Nodes' changes as affine functions of (1, dh, dv): a band matrix of two subdiagonals, LU with row exchanges.
  bool linearise() {
    const int nodes = intervals() + 1;
    const int rows = 2 * nodes;
    constexpr int kBand = 7;  // columns r-2 ... r+4 of row r
    std::vector<std::array<double, kBand>> band(rows);
    std::vector<Eigen::RowVector3d> right(rows);
    const auto entry = [&](int r, int c) -> double& { return band[r][c - r + 2]; };
    for (auto& row : band) row.fill(0.0);
    entry(0, 1) = 1.0;
    right[0] << -intervals_.front().node.y(), 0.0, 0.0;
    for (int k = 0; k < intervals(); ++k) {
      condense(&intervals_[k]);
      const Interval& interval = intervals_[k];
      const Eigen::Vector2d next = node(k + 1);
      for (int i = 0; i < 2; ++i) {
        const int r = 1 + 2 * k + i;
        for (int j = 0; j < 2; ++j) entry(r, 2 * k + j) = interval.to_next(i, j);
        entry(r, 2 * k + 2 + i) = -1.0;
        right[r] << next(i) - interval.to_next(i, 4), -interval.to_next(i, 2), -interval.to_next(i, 3);
      }
    }
    entry(rows - 1, rows - 1) = 1.0;
    right[rows - 1] << -last_.y(), 0.0, 0.0;

    for (int c = 0; c < rows; ++c) {
      int pivot = c;
      for (int r = c + 1; r <= std::min(c + 2, rows - 1); ++r) {
        if (std::abs(entry(r, c)) > std::abs(entry(pivot, c))) pivot = r;
      }
      const int last = std::min(c + 4, rows - 1);
      if (pivot != c) {
        for (int j = c; j <= last; ++j) std::swap(entry(c, j), entry(pivot, j));
        std::swap(right[c], right[pivot]);
      }
      if (entry(c, c) == 0.0) return false;
      for (int r = c + 1; r <= std::min(c + 2, rows - 1); ++r) {
        const double factor = entry(r, c) / entry(c, c);
        if (factor == 0.0) continue;
        for (int j = c; j <= last; ++j) entry(r, j) -= factor * entry(c, j);
        right[r] -= factor * right[c];
      }
    }
    changes_.resize(rows);
    for (int r = rows - 1; r >= 0; --r) {
      Eigen::RowVector3d sum = right[r];
      for (int j = r + 1; j <= std::min(r + 4, rows - 1); ++j) sum -= entry(r, j) * changes_[j];
      changes_[r] = sum / entry(r, r);
    }
    end_.setZero();
    compliance_.setZero();
    for (int k = 0; k < intervals(); ++k) {
      const Interval& interval = intervals_[k];
      const Eigen::Matrix<double, 2, 3> change = nodeChange(k);
      end_ += interval.along.col(4) + interval.along.leftCols<2>() * change.col(0);
      compliance_ += interval.along.middleCols<2>(2) + interval.along.leftCols<2>() * change.rightCols<2>();
    }
    return end_.allFinite() && compliance_.allFinite();
  }

  Eigen::Vector2d node(int k) const { return k < intervals() ? intervals_[k].node : last_; }

  Eigen::Matrix<double, 2, 3> nodeChange(int k) const {
    Eigen::Matrix<double, 2, 3> change;
    change << changes_[2 * k], changes_[2 * k + 1];
    return change;
  }

  double turn(const Eigen::Vector2d& change) const {
    double largest = 0.0;
    const Eigen::Vector3d factors(1.0, change.x(), change.y());
    for (int k = 0; k <= intervals(); ++k) largest = std::max(largest, std::abs(nodeChange(k).row(0) * factors));
    return largest;
  }

  void advance(const Eigen::Vector2d& change, double damping) {
    const Eigen::Vector3d factors(1.0, change.x(), change.y());
    for (int k = 0; k < intervals(); ++k) {
      const Eigen::Vector2d dy = nodeChange(k) * factors;
      Eigen::Matrix<double, 5, 1> inner;
      inner << dy, change, 1.0;
      const Eigen::Matrix<double, 2 * kStages, 1> stages = damping * (intervals_[k].stages * inner);
      for (int j = 0; j < kStages; ++j) intervals_[k].stage[j] += stages.segment<2>(2 * j);
      intervals_[k].node += damping * dy;
    }
    last_ += damping * (nodeChange(intervals()) * factors);
    scaled_.force += damping * change;
  }

  ClaimedCable claim_;
  double force_scale_ = 1.0;
  double fineness_ = 1.0;
  double bend_ = 0.0;  // length over which a narrow loop turns, (EI/q)^(1/3)
  Scaled scaled_;
  std::vector<Interval> intervals_;
  Eigen::Vector2d last_;
  std::vector<Eigen::RowVector3d> changes_;
  Eigen::Vector2d end_;
  Eigen::Matrix2d compliance_;
  int iterations_ = 0;
};

// The largest turn without a loop is the teardrop's, 261 degrees (docs/theory.md section 3).
constexpr double kLoopAngle = 1.65 * M_PI;

}  // namespace

bool VerifiedCable::sags() const {
  return stable && area_below_chord >= -1e-9 * (x * x + y * y) && std::abs(turning) < kLoopAngle;
}

VerifiedCable verify(const ClaimedCable& claim, Kept kept) {
  VerifiedCable result;
  Collocation coarse(claim, 1.0);
  result.intervals = coarse.intervals();
  const bool first = coarse.solve(kept);
  result.iterations = coarse.iterations();
  if (!first) return result;
  ClaimedCable better = claim;
  better.h = coarse.force().x();
  better.v = coarse.force().y();
  Collocation fine(better, kFiner);
  const bool second = fine.solve(kept);
  result.iterations += fine.iterations();
  result.intervals = fine.intervals();
  if (!second) return result;
  result.converged = true;
  result.h = fine.force().x();
  result.v = fine.force().y();
  result.x = fine.end().x();
  result.y = fine.end().y();
  result.angle_a = fine.angleA();
  result.angle_b = fine.angleB();
  result.force_error = (fine.force() - coarse.force()).norm();
  result.end_error = (fine.end() - coarse.end()).norm();
  // Near a bifurcation the second variation needs more points than the shape.
  result.stable = fine.stable();
  if (!result.stable) {
    Collocation finest(better, kFinest);
    result.stable = finest.solve(kept) && finest.stable();
  }
  result.area_below_chord = fine.areaBelowChord();
  result.turning = fine.angleB() - fine.angleA();
  result.compliance = fine.compliance();
  return result;
}

}  // namespace cdpr_kinetostatics
