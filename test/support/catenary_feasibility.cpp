#include "catenary_feasibility.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "robot_audit.h"

namespace cdpr_kinetostatics {
namespace {

struct CurvePoint {
  double h = 0.0, v = 0.0, length = 0.0;
  double tension() const { return std::hypot(h, v); }
};

CurvePoint between(const CurvePoint& a, const CurvePoint& b, double tension) {
  const double share = (tension - a.tension()) / (b.tension() - a.tension());
  return {a.h + share * (b.h - a.h), a.v + share * (b.v - a.v), a.length + share * (b.length - a.length)};
}

// With H sinh(m +- d/2) the vertical forces at A and B, the textbook formulas are
//   x = (H/q) (d + (H/EA) 2 cosh m sinh(d/2)),   y = -(H/q) (2 sinh m sinh(d/2) + (H/2 EA) sinh(2 m) sinh d).
class CatenaryCurve {
 public:
  CatenaryCurve(const CableProperties& cable, double x, double y) : cable_(cable), x_(x), y_(y) {}

  // From just above this tension down to the least one, in steps of H of 7 %.
  std::vector<CurvePoint> fromTension(double most) {
    std::vector<CurvePoint> curve;
    const double chord = std::hypot(x_, y_);
    double h = 1.05 * most * x_ / chord + cable_.weight * chord;
    m_ = std::asinh(-y_ / x_);
    d_ = cable_.weight * x_ / h;
    for (; solve(h); h *= 0.93) {
      const double q = cable_.weight;
      curve.push_back({h, h * std::sinh(m_ + 0.5 * d_), h / q * 2.0 * std::cosh(m_) * std::sinh(0.5 * d_)});
      if (curve.size() > 1 && curve.back().tension() > curve[curve.size() - 2].tension()) {
        curve.pop_back();
        break;
      }
    }
    return curve;
  }

 private:
  bool solve(double h) {
    const double a = h / cable_.weight;
    const double k = h / cable_.axial_stiffness;
    double last = 1e300;
    for (int i = 0; i < 60; ++i) {
      const double cm = std::cosh(m_), sm = std::sinh(m_), sd = std::sinh(0.5 * d_), cd = std::cosh(0.5 * d_);
      const Eigen::Vector2d open(a * (d_ + 2.0 * k * cm * sd) - x_,
                                 -a * (2.0 * sm * sd + 0.5 * k * std::sinh(2.0 * m_) * std::sinh(d_)) - y_);
      const double size = open.norm() / std::hypot(x_, y_);
      if (size < 1e-12 && size >= 0.5 * last) return true;
      last = size;
      Eigen::Matrix2d slope;
      slope << 2.0 * a * k * sm * sd, a * (1.0 + k * cm * cd),
          -a * (2.0 * cm * sd + k * std::cosh(2.0 * m_) * std::sinh(d_)),
          -a * (sm * cd + 0.5 * k * std::sinh(2.0 * m_) * std::cosh(d_));
      const Eigen::Vector2d step = slope.inverse() * open;
      if (!step.allFinite()) return false;
      const double damping = std::min({1.0, 1.0 / std::abs(step(0)), 0.7 * d_ / std::abs(step(1))});
      m_ -= damping * step(0);
      d_ -= damping * step(1);
    }
    return false;
  }

  const CableProperties cable_;
  const double x_, y_;
  double m_ = 0.0, d_ = 0.0;
};

// The least |matrix x - right| of non-negative x (Lawson and Hanson).
double leastResidual(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  const Eigen::Index n = matrix.cols();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<int> free;
  for (Eigen::Index i = 0; i < 10 * n; ++i) {
    const Eigen::VectorXd gain = matrix.transpose() * (right - matrix * x);
    int enters = -1;
    for (int j = 0; j < n; ++j) {
      if (std::find(free.begin(), free.end(), j) != free.end() || gain(j) < 1e-11 * matrix.col(j).norm()) continue;
      if (enters < 0 || gain(j) > gain(enters)) enters = j;
    }
    if (enters < 0) break;
    free.push_back(enters);
    while (!free.empty()) {
      const Eigen::VectorXd best = matrix(Eigen::all, free).colPivHouseholderQr().solve(right);
      if (best.minCoeff() > 0.0) {
        x.setZero();
        x(free) = best;
        break;
      }
      double share = 1.0;
      for (std::size_t k = 0; k < free.size(); ++k) {
        const double aim = best(static_cast<Eigen::Index>(k));
        if (aim <= 0.0) share = std::min(share, x(free[k]) / (x(free[k]) - aim));
      }
      std::vector<int> kept;
      for (std::size_t k = 0; k < free.size(); ++k) {
        double& value = x(free[k]);
        value += share * (best(static_cast<Eigen::Index>(k)) - value);
        if (value > 1e-14) {
          kept.push_back(free[k]);
        } else {
          value = 0.0;
        }
      }
      free = kept;
    }
  }
  return (matrix * x - right).norm();
}

}  // namespace

std::optional<bool> catenariesCanHold(const RobotDescription& robot, const Pose& pose, double margin) {
  const auto n = static_cast<Eigen::Index>(robot.cables.size());
  std::vector<PlaneForces> none(robot.cables.size());
  const auto scaled = [&](Wrench wrench) {
    wrench.tail<3>() /= robot.lever();
    return Wrench(wrench / robot.weight());
  };
  const Wrench load = scaled(totalWrench(robot, Wrench::Zero(), pose, none));
  std::vector<Wrench> wrenches;
  std::vector<Eigen::Index> owners;
  for (Eigen::Index i = 0; i < n; ++i) {
    const CableDescription& cable = robot.cables[static_cast<std::size_t>(i)];
    const Eigen::Vector3d to_b = attachmentInWorld(pose, cable.attachment) - cable.anchor;
    const double x = to_b.head<2>().norm();
    if (x < 1e-3) return std::nullopt;
    const std::vector<CurvePoint> curve = CatenaryCurve(cable.properties, x, to_b.z()).fromTension(cable.tension_max);
    if (curve.size() < 3) return std::nullopt;
    const double range = cable.tension_max - cable.tension_min;
    const double least = std::max(cable.tension_min, curve.back().tension()) + margin * range;
    const double most = cable.tension_max - margin * range;
    if (least > most) return false;
    std::vector<CurvePoint> inside;
    for (std::size_t k = 1; k < curve.size(); ++k) {
      const CurvePoint &above = curve[k - 1], &below = curve[k];
      for (const double limit : {most, least}) {
        if (above.tension() >= limit && below.tension() < limit) inside.push_back(between(above, below, limit));
      }
      const bool sampled = k % 6 == 0 || k + 6 > curve.size();
      if (sampled && below.tension() < most && below.tension() > least) inside.push_back(below);
    }
    for (const CurvePoint& point : inside) {
      std::vector<PlaneForces> forces = none;
      forces[static_cast<std::size_t>(i)] = {point.h, point.v, point.length};
      wrenches.push_back(scaled(totalWrench(robot, Wrench::Zero(), pose, forces)) - load);
      owners.push_back(i);
    }
  }
  // Shares of the wrenches of a cable add up to one.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6 + n, static_cast<Eigen::Index>(wrenches.size()));
  for (Eigen::Index k = 0; k < matrix.cols(); ++k) {
    matrix.col(k).head<6>() = wrenches[static_cast<std::size_t>(k)];
    matrix(6 + owners[static_cast<std::size_t>(k)], k) = 1.0;
  }
  Eigen::VectorXd right = Eigen::VectorXd::Ones(6 + n);
  right.head<6>() = -load;
  return leastResidual(matrix, right) < 1e-7;
}

RobotDescription randomRobot(bool zero_tension_min, Dice* dice) {
  const auto logarithmic = [dice](double low, double high) {
    return std::exp(dice->uniform(std::log(low), std::log(high)));
  };
  RobotDescription robot;
  robot.name = "random";
  const int n = 6 + static_cast<int>(dice->uniform(0.0, 7.0));
  const double size = logarithmic(1.0, 20.0);
  const Eigen::Vector3d half = size * dice->inBox({0.4, 0.4, 0.3}, {1.0, 1.0, 1.0});
  const double radius = size * logarithmic(0.03, 0.2);
  robot.mass = logarithmic(2.0, 300.0);
  robot.com = radius * dice->uniform(0.0, 0.3) * dice->direction();
  const bool suspended = dice->uniform(0.0, 1.0) < 0.35;
  const double diameter = logarithmic(1e-3, 8e-3);
  const double modulus = logarithmic(5e9, 2e11);
  const double area = M_PI * diameter * diameter / 4.0;
  const double tension_max = robot.weight() * logarithmic(0.6, 10.0);
  CableDescription cable;
  cable.properties.axial_stiffness = modulus * area;
  cable.properties.bending_stiffness = logarithmic(1e-3, 1.0) * modulus * area * diameter * diameter / 16.0;
  cable.properties.weight = dice->uniform(1000.0, 8000.0) * area * robot.gravity;
  cable.tension_max = tension_max;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * (i + dice->uniform(0.0, 0.8)) / n * (n > 6 ? 2 : 1);
    const double beside = angle + dice->uniform(-0.8, 0.8);
    const bool above = suspended || dice->uniform(0.0, 1.0) < 0.55;
    cable.name = "cable" + std::to_string(i);
    cable.anchor = half.cwiseProduct(dice->inBox({0.8, 0.8, 0.6}, {1.2, 1.2, 1.3}));
    cable.anchor.x() *= std::cos(angle);
    cable.anchor.y() *= std::sin(angle);
    if (!above) cable.anchor.z() *= -1.0;
    cable.attachment = radius * Eigen::Vector3d(std::cos(beside), std::sin(beside), dice->uniform(-1.0, 1.0));
    cable.tension_min = zero_tension_min ? 0.0 : tension_max * dice->uniform(0.001, 0.03);
    robot.cables.push_back(cable);
  }
  return robot;
}

Pose randomPoseOf(const RobotDescription& robot, Dice* dice) {
  Eigen::Vector3d low = robot.cables[0].anchor;
  Eigen::Vector3d high = low;
  for (const CableDescription& cable : robot.cables) {
    low = low.cwiseMin(cable.anchor);
    high = high.cwiseMax(cable.anchor);
  }
  if (high.z() - low.z() < 0.3 * (high.x() - low.x())) low.z() -= high.x() - low.x();  // all anchors above
  Pose pose;
  pose.position = dice->inBox(0.8 * low + 0.2 * high, 0.2 * low + 0.8 * high);
  pose.orientation = Eigen::AngleAxisd(dice->uniform(0.0, 0.4), dice->direction());
  return pose;
}

}  // namespace cdpr_kinetostatics
