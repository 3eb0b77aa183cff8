#include "cable/cable_evaluation.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cable/bending_expansion.h"
#include "cable/catenary.h"
#include "cable/straight.h"

namespace cdpr_kinetostatics {
namespace {

// Numbers that do not exist (the compliance of a narrow loop is infinite) are reported as zero.
template <typename Matrix>
void zeroNonFinite(Matrix* matrix) {
  *matrix = matrix->unaryExpr([](double value) { return std::isfinite(value) ? value : 0.0; });
}

CableSolution forcesOf(const CableProperties& cable, Model model, double length, double h, double v) {
  CableSolution solution;
  solution.status.code = Code::kConverged;
  solution.model = model;
  solution.length = length;
  solution.strained_length = length;
  solution.horizontal_force = h;
  solution.vertical_force_a = v;
  solution.tension_a = std::hypot(h, v);
  solution.tension_b = std::hypot(h, v - cable.weight * length);
  return solution;
}

void describeStraight(const CableProperties& cable, double x, double y, int profile_points, CableSolution* solution) {
  const double line_v = solution->vertical_force_a - 0.5 * cable.weight * solution->length;
  const double tension = std::hypot(solution->horizontal_force, line_v);
  const double angle = std::atan2(y, x);
  solution->x = x;
  solution->y = y;
  solution->angle_a = solution->angle_b = angle;
  if (tension > 0.0) {
    solution->strained_length = solution->length * (1.0 + tension / cable.axial_stiffness);
    const EndPoint end = straightEnd(cable, solution->horizontal_force, solution->vertical_force_a, solution->length);
    solution->end_jacobian = end.jacobian;
    solution->closure_residual = std::abs(std::hypot(x, y) - solution->strained_length);
    if (std::isfinite(cable.axial_stiffness)) solution->force_jacobian = forceJacobian(end);
  } else {
    solution->force_jacobian(1, 2) = 0.5 * cable.weight;
  }
  for (int i = 0; i < profile_points; ++i) {
    const double share = static_cast<double>(i) / (profile_points - 1);
    solution->profile.push_back({share * solution->length, share * x, share * y, angle, 0.0, tension, 0.0});
  }
}

// The corrected catenary at unstrained arc length s: bending follows the catenary's curvature but for the layers
// at the free ends, where the moment falls to zero.
ProfilePoint correctedPoint(const CableProperties& cable, double s, const CableSolution& at) {
  const double h = at.horizontal_force;
  const double u = cable.weight * s - at.vertical_force_a;
  const double tension = std::hypot(h, u);
  const double curvature = cable.weight * h / (tension * tension) / (1.0 + tension / cable.axial_stiffness);
  const double thickness = std::sqrt(cable.bending_stiffness / tension);
  const double layer_a = std::exp(-s / thickness);
  const double layer_b = std::exp(-(at.length - s) / thickness);
  const double moment = cable.bending_stiffness * curvature;
  const double inside = (1.0 - layer_a) * (1.0 - layer_b);
  ProfilePoint point;
  point.s = s;
  point.alpha = std::atan2(u, h) + curvature * thickness * (layer_a - layer_b);
  point.moment = moment * inside;
  point.tension = tension;
  point.shear = moment / thickness * (layer_b - layer_a);
  if (s > 0.0) {
    const Eigen::Vector2d middle = correctedCatenaryEnd(cable, h, at.vertical_force_a, s).position +
                                   inside * moment / tension * Eigen::Vector2d(-u, h) / tension;
    point.x = middle.x();
    point.y = middle.y();
  }
  return point;
}

void describeCorrection(const CableProperties& cable, int profile_points, CableSolution* solution) {
  const double lowest = std::clamp(solution->vertical_force_a / cable.weight, 0.0, solution->length);
  const ProfilePoint a = correctedPoint(cable, 0.0, *solution);
  const ProfilePoint b = correctedPoint(cable, solution->length, *solution);
  solution->angle_a = a.alpha;
  solution->angle_b = b.alpha;
  const double lowest_tension =
      std::hypot(solution->horizontal_force, cable.weight * lowest - solution->vertical_force_a);
  solution->max_moment = cable.bending_stiffness * cable.weight * solution->horizontal_force /
                         (lowest_tension * lowest_tension) / (1.0 + lowest_tension / cable.axial_stiffness);
  solution->max_shear = std::max(std::abs(a.shear), std::abs(b.shear));
  for (int i = 0; i < profile_points; ++i) {
    solution->profile.push_back(correctedPoint(cable, solution->length * i / (profile_points - 1), *solution));
  }
}

void describeCatenary(const CableProperties& cable, int profile_points, CableSolution* solution) {
  const double h = solution->horizontal_force;
  const double v = solution->vertical_force_a;
  const double length = solution->length;
  const EndPoint end = correctedCatenaryEnd(cable, h, v, length);
  solution->x = end.position.x();
  solution->y = end.position.y();
  solution->end_jacobian = end.jacobian;
  solution->force_jacobian = forceJacobian(end);
  solution->strained_length = catenaryStrainedLength(cable, h, v, length);
  solution->angle_a = catenaryAngle(cable, h, v, 0.0);
  solution->angle_b = catenaryAngle(cable, h, v, length);
  const double chord = std::hypot(solution->x, solution->y);
  if (cable.weight > 0.0 && h > 0.0 && chord > 0.0) {  // farthest from the chord where parallel to it
    const double s = std::clamp((v + h * solution->y / solution->x) / cable.weight, 0.0, length);
    const Eigen::Vector2d at = s > 0.0 ? catenaryEnd(cable, h, v, s).position : Eigen::Vector2d::Zero();
    solution->sag = std::abs(at.x() * solution->y - at.y() * solution->x) / chord;
  }
  if (cable.bending_stiffness > 0.0 && cable.weight > 0.0 && h > 0.0) {
    return describeCorrection(cable, profile_points, solution);
  }
  for (int i = 0; i < profile_points; ++i) {
    const double s = length * i / (profile_points - 1);
    const Eigen::Vector2d at = i > 0 ? catenaryEnd(cable, h, v, s).position : Eigen::Vector2d::Zero();
    solution->profile.push_back(
        {s, at.x(), at.y(), catenaryAngle(cable, h, v, s), 0.0, std::hypot(h, v - cable.weight * s), 0.0});
  }
}

}  // namespace

CableProperties asSeenBy(Model model, const CableProperties& cable) {
  CableProperties seen = cable;
  if (isInextensible(model)) seen.axial_stiffness = std::numeric_limits<double>::infinity();
  if (!isBending(model) && model != Model::kCatenaryCorrected) seen.bending_stiffness = 0.0;
  return seen;
}

Eigen::Matrix<double, 2, 3> forceJacobian(const EndPoint& end) {
  const Eigen::Matrix2d compliance = end.jacobian.leftCols<2>();
  Eigen::Matrix<double, 2, 3> jacobian;
  if (std::isinf(compliance(0, 0))) {  // a vertical loop: only its height acts, on V
    jacobian.setZero();
    jacobian(1, 1) = 1.0 / compliance(1, 1);
    jacobian(1, 2) = -end.jacobian(1, 2) / compliance(1, 1);
  } else {
    const Eigen::Matrix2d stiffness = compliance.inverse();
    jacobian << stiffness, -stiffness * end.jacobian.col(2);
  }
  zeroNonFinite(&jacobian);
  return jacobian;
}

CableSolution describeClosedForm(const CableProperties& properties, Model model, double length, double h, double v,
                                 double x, double y, int profile_points) {
  const CableProperties cable = asSeenBy(model, properties);
  CableSolution solution = forcesOf(cable, model, length, h, v);
  if (isStraight(model)) {
    describeStraight(cable, x, y, profile_points, &solution);
  } else {
    describeCatenary(cable, profile_points, &solution);
    solution.closure_residual = std::hypot(solution.x - x, solution.y - y);
  }
  zeroNonFinite(&solution.end_jacobian);
  return solution;
}

CableSolution describeBending(const CableProperties& properties, Model model, const MultipleShooting& shooting,
                              int profile_points) {
  CableSolution solution = forcesOf(asSeenBy(model, properties), model, shooting.length(), shooting.horizontalForce(),
                                    shooting.verticalForceA());
  shooting.measure(profile_points, &solution);
  solution.end_jacobian = shooting.end().jacobian;
  solution.force_jacobian = forceJacobian(shooting.end());
  solution.moment_residual = shooting.momentDefect();
  return solution;
}

}  // namespace cdpr_kinetostatics
