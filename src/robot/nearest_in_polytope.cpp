#include "robot/nearest_in_polytope.h"

#include <Eigen/QR>
#include <limits>

namespace cdpr_kinetostatics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Constraint p is parallel to the active ones below this share of its norm.
constexpr double kParallel = 1e-10;

class DualActiveSet {
 public:
  DualActiveSet(const Eigen::MatrixXd& normals, const Eigen::VectorXd& bounds, Eigen::VectorXd x)
      : normals_(normals), bounds_(bounds), x_(std::move(x)) {}

  const Eigen::VectorXd& x() const { return x_; }
  const std::vector<int>& active() const { return active_; }

  // The most violated constraint, or -1.
  int mostViolated(double tolerance) const {
    const Eigen::VectorXd slack = normals_.transpose() * x_ - bounds_;
    Eigen::Index worst = 0;
    return slack.size() > 0 && slack.minCoeff(&worst) < -tolerance ? static_cast<int>(worst) : -1;
  }

  // Moves to the optimum with constraint p active too. False if it contradicts the active ones.
  bool add(int p) {
    double multiplier = 0.0;
    for (;;) {
      const Eigen::VectorXd normal = normals_.col(p);
      Eigen::VectorXd direction = normal;
      Eigen::VectorXd exchange;
      if (!active_.empty()) {
        const Eigen::MatrixXd base = normals_(Eigen::all, active_);
        exchange = base.colPivHouseholderQr().solve(normal);
        direction -= base * exchange;
      }
      const double missing = bounds_(p) - normal.dot(x_);
      const bool movable = direction.norm() > kParallel * normal.norm();
      const double full = movable ? missing / direction.dot(normal) : kInfinity;
      double partial = kInfinity;
      std::size_t leaving = 0;
      for (std::size_t j = 0; j < active_.size(); ++j) {
        if (exchange(j) > 0.0 && multipliers_[j] / exchange(j) < partial) {
          partial = multipliers_[j] / exchange(j);
          leaving = j;
        }
      }
      const double step = std::min(full, partial);
      if (step == kInfinity) return false;
      for (std::size_t j = 0; j < active_.size(); ++j) multipliers_[j] -= step * exchange(j);
      multiplier += step;
      if (movable) x_ += step * direction;
      if (full <= partial) {
        active_.push_back(p);
        multipliers_.push_back(multiplier);
        return true;
      }
      active_.erase(active_.begin() + leaving);
      multipliers_.erase(multipliers_.begin() + leaving);
    }
  }

 private:
  const Eigen::MatrixXd& normals_;
  const Eigen::VectorXd& bounds_;
  Eigen::VectorXd x_;
  std::vector<int> active_;
  std::vector<double> multipliers_;
};

}  // namespace

NearestPoint nearestInPolytope(const Eigen::VectorXd& x0, const Eigen::MatrixXd& normals, const Eigen::VectorXd& bounds,
                               double tolerance, SolveLimits::Clock::time_point deadline) {
  DualActiveSet set(normals, bounds, x0);
  NearestPoint nearest;
  // Every addition raises the distance from x0, so no active set comes twice; the cap is for rounding.
  const int cap = 100 * static_cast<int>(bounds.size() + 1);
  for (int i = 0; i < cap && SolveLimits::Clock::now() < deadline; ++i) {
    const int p = set.mostViolated(tolerance);
    if (p < 0 || !set.add(p)) {
      nearest.feasible = p < 0;
      nearest.x = set.x();
      nearest.active = set.active();
      if (p >= 0) nearest.active.push_back(p);
      return nearest;
    }
  }
  nearest.x = set.x();
  nearest.active = set.active();
  return nearest;
}

}  // namespace cdpr_kinetostatics
