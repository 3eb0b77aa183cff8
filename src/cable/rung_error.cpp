#include "cable/rung_error.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cable/bending_expansion.h"
#include "cable/pulley_cable.h"
#include "cable/pulley_end.h"
#include "cable/pulley_expansion.h"
#include "cable/rope_on_pulley.h"
#include "cable/sagging_cable.h"
#include "cable/straight_cable.h"
#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

// Forces that change by more than this share do not change in proportion to what changes them.
constexpr double kLinear = 0.1;

Eigen::Matrix2d inverseOrZero(const Eigen::Matrix2d& compliance) {
  const Eigen::Matrix2d inverse = compliance.inverse();
  return inverse.allFinite() ? inverse : Eigen::Matrix2d::Zero();
}

// An error of the end by `end` at given forces, of a cable of that tension and stiffness.
RungError errorOf(const Eigen::Vector2d& end, const Eigen::Matrix2d& stiffness, bool known, double tension,
                  double length) {
  RungError error{end, -stiffness * end, stiffness, end.norm(), known};
  error.known = known && error.force.norm() <= kLinear * tension;
  if (!end.allFinite()) return {{length, 0.0}, Eigen::Vector2d::Zero(), stiffness, length, false};
  const double share = end.norm() / length;
  if (share <= 1.0) return error;
  error.end /= share;  // no end moves by more than the cable is long
  error.force /= share;
  error.displacement = length;
  error.known = false;
  return error;
}

// The end of the cable without bending stiffness, as a line or a catenary, under the given forces at A.
EndPoint endWithoutBending(const CableProperties& cable, FreeShape shape, double h, double v, double length) {
  if (beginsAtEyelet(cable)) return freeEnd(cable, shape, {h, v}, length);
  return pulleyEnd(cable, shape, {h, v}, length).end;
}

// What bending does to the catenary, where it leaves a pulley as well.
BendingExpansion bendingFrom(const CableProperties& cable, double h, double v, double length) {
  return beginsAtEyelet(cable) ? bendingExpansion(cable, h, v, length) : pulleyExpansion(cable, {h, v}, length);
}

// Problem 2 of the line that stretches.
ForcesAtA lineForces(const CableProperties& cable, double length, const Eigen::Vector2d& end) {
  if (beginsAtEyelet(cable)) return straightForces(cable, length, end.x(), end.y());
  PulleyCable line(cable, FreeShape::kStraight);
  const double none = std::numeric_limits<double>::quiet_NaN();
  return line.startBetween(length, end.x(), end.y(), {}).ok() ? line.forces() : ForcesAtA{none, none};
}

// How far the end of the cable under the line's own forces lies from the line's; a slack line's hang both ends of the
// cable side by side.
double displacementOfLine(const CableProperties& cable, const CableSolution& line) {
  const double h = line.horizontal_force;
  const double v = line.vertical_force_a;
  const Eigen::Vector2d moved =
      endWithoutBending(cable, FreeShape::kCatenary, h, v, line.length).position - Eigen::Vector2d(line.x, line.y);
  if (!moved.allFinite()) return line.length;
  // A sharp bend at the bottom of a slack cable is none for the expansion, and moves the end by less than its length.
  const BendingExpansion bending = bendingFrom(cable, h, v, line.length);
  return bending.trusted ? (moved + bending.end).norm() : moved.norm();
}

// A line that stretches, or is slack, between given ends, against the cable that hangs there.
RungError lineBetweenEnds(const CableProperties& cable, const CableSolution& line) {
  const bool formless = cable.weight == 0.0 && cable.bending_stiffness == 0.0;
  if (formless && std::hypot(line.x, line.y) <= line.length) {
    return errorOf(Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero(), true, 0.0, line.length);
  }
  const std::optional<ForcesAtA> catenary =
      hangingForces(asSeenBy(Model::kCatenary, cable), line.length, line.x, line.y);
  if (!catenary) return {{line.length, 0.0}, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero(), line.length, false};
  const EndPoint end =
      endWithoutBending(cable, FreeShape::kCatenary, catenary->horizontal, catenary->vertical, line.length);
  const Eigen::Matrix2d compliance = end.jacobian.leftCols<2>();
  const BendingExpansion bending = bendingFrom(cable, catenary->horizontal, catenary->vertical, line.length);
  const Eigen::Vector2d force(catenary->horizontal - line.horizontal_force, catenary->vertical - line.vertical_force_a);
  RungError error = errorOf(bending.end - compliance * force, inverseOrZero(compliance), bending.trusted,
                            std::hypot(catenary->horizontal, catenary->vertical), line.length);
  error.displacement = displacementOfLine(cable, line);
  return error;
}

}  // namespace

RungError rungError(const CableProperties& cable, const CableSolution& solution) {
  const Model model = solution.model;
  const auto [h, v] = withoutRounding({solution.horizontal_force, solution.vertical_force_a});
  const double length = solution.length;
  CableProperties stretching = cable;
  if (!(cable.axial_stiffness > 0.0)) stretching.axial_stiffness = std::numeric_limits<double>::infinity();
  if (model == Model::kBending) {
    return errorOf(Eigen::Vector2d::Zero(), solution.force_jacobian.leftCols<2>(), true, solution.tension_a, length);
  }
  if (model == Model::kStraightElastic) return lineBetweenEnds(stretching, solution);
  if (!pullsAllAlong(stretching, length, {h, v})) {
    const double strain = solution.tension_a / stretching.axial_stiffness;
    return errorOf(strain * Eigen::Vector2d(solution.x, solution.y), solution.force_jacobian.leftCols<2>(),
                   isBending(model), solution.tension_a, length);
  }
  const EndPoint catenary = endWithoutBending(stretching, FreeShape::kCatenary, h, v, length);
  const CableProperties seen = asSeenBy(model, stretching);
  Eigen::Vector2d end = Eigen::Vector2d::Zero();
  if (isStraight(model)) {
    end = catenary.position - endWithoutBending(seen, FreeShape::kStraight, h, v, length).position;
  } else if (isInextensible(model)) {
    end = catenary.position - endWithoutBending(seen, FreeShape::kCatenary, h, v, length).position;
  }
  bool known = true;
  if (!isBending(model)) {
    const BendingExpansion bending = bendingFrom(stretching, h, v, length);
    end += model == Model::kCatenaryCorrected ? bending.beyond_first : bending.end;
    known = bending.trusted;
  }
  return errorOf(end, inverseOrZero(catenary.jacobian.leftCols<2>()), known, solution.tension_a, length);
}

RungErrors rungErrors(const CableProperties& cable, double length, double horizontal_force, double vertical_force_a) {
  RungErrors errors;
  const auto [h, v] = withoutRounding({horizontal_force, vertical_force_a});
  if (!pullsAllAlong(cable, length, {h, v})) {
    for (RungError& error : errors) error.known = false;
    errors.back().known = true;
    return errors;
  }
  const EndPoint catenary = endWithoutBending(cable, FreeShape::kCatenary, h, v, length);
  const Eigen::Matrix2d compliance = catenary.jacobian.leftCols<2>();
  const Eigen::Matrix2d stiffness = inverseOrZero(compliance);
  const BendingExpansion bending = bendingFrom(cable, h, v, length);
  const ForcesAtA line = lineForces(cable, length, catenary.position);
  const Eigen::Vector2d off_line = compliance * Eigen::Vector2d(line.horizontal - h, line.vertical - v);
  const std::array<Eigen::Vector2d, kAutoRungCount> ends = {bending.end + off_line, bending.end, bending.beyond_first,
                                                            Eigen::Vector2d::Zero()};
  for (std::size_t r = 0; r < ends.size(); ++r) {
    errors[r] =
        errorOf(ends[r], stiffness, bending.trusted || kAutoRungs[r] == Model::kBending, std::hypot(h, v), length);
  }
  return errors;
}

}  // namespace cdpr_kinetostatics
