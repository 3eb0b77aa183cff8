// The estimates of what every model neglects, against BENDING.
#include <gtest/gtest.h>

#include <cmath>

#include "cable/bending_expansion.h"
#include "cable/catenary.h"
#include "cable/rung_error.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"
#include "loaded_cable.h"

namespace cdpr_kinetostatics {
namespace {

CableSolverOptions options(Model model, double tolerance = 1e-8) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = tolerance;
  return result;
}

Eigen::Vector2d trueEffect(const LoadedCable& c) {
  const CableSolution bending = findPosition(c.cable, c.length, c.h, c.v, options(Model::kBending, 1e-12));
  const EndPoint catenary = catenaryEnd(c.cable, c.h, c.v, c.length);
  EXPECT_TRUE(bending.status.ok()) << bending.status.message;
  return Eigen::Vector2d(bending.x, bending.y) - catenary.position;
}

// The estimate is to leading order, so it is judged by its ratio to the truth; the worst measured is 0.3 off.
TEST(EstimatedError, IsThatOfTheRung) {
  Dice dice(5);
  int trusted = 0;
  for (int k = 0; k < 600; ++k) {
    const LoadedCable c = randomLoaded(&dice, 1.0);
    const BendingExpansion effect = bendingExpansion(c.cable, c.h, c.v, c.length);
    if (!effect.trusted) continue;
    const Eigen::Vector2d truth = trueEffect(c);
    const Eigen::Vector2d first = firstOrderBending(c.cable, c.h, c.v, c.length).position;
    if (truth.norm() < 1e-11 * c.length) continue;  // rounding of the integration
    ++trusted;
    EXPECT_LT((effect.end - truth).norm(), 0.4 * truth.norm()) << "scene " << k;
    if ((truth - first).norm() < 1e-11 * c.length) continue;
    const double ratio = effect.beyond_first.norm() / (truth - first).norm();
    EXPECT_GT(ratio, 0.3) << "scene " << k;
    EXPECT_LT(ratio, 2.0) << "scene " << k;
  }
  EXPECT_GT(trusted, 250);
}

TEST(EstimatedError, IsReportedByEveryRung) {
  // A taut rope: every rung has an answer at the length of its own problem 3.
  const CableProperties rope = steelRope();
  for (int m = static_cast<int>(Model::kStraight); m <= static_cast<int>(Model::kBending); ++m) {
    const auto model = static_cast<Model>(m);
    const CableSolution s = findLength(rope, 7.0, -4.0, 300.0, 0.0, options(model));
    ASSERT_TRUE(s.status.ok()) << modelName(model) << s.status.message;
    const CableSolution truth =
        findPosition(rope, s.length, s.horizontal_force, s.vertical_force_a, options(Model::kBending, 1e-11));
    const double error = std::hypot(truth.x - s.x, truth.y - s.y);
    EXPECT_NEAR(s.estimated_error, error, 0.1 * error + 1e-9) << modelName(model);
  }
}

// CableState.msg defines it: how far B would be displaced under the same forces, slack lines included.
TEST(EstimatedError, OfALineIsThatUnderItsOwnForces) {
  for (const double length : {8.9, 8.94, 8.944}) {  // chord 8.9443
    const CableSolution line = findForces(steelRope(), length, 8.0, -4.0, options(Model::kStraightElastic));
    ASSERT_TRUE(line.status.ok()) << line.status.message;
    const CableSolution truth = findPosition(steelRope(), length, line.horizontal_force, line.vertical_force_a,
                                             options(Model::kBending, 1e-11));
    ASSERT_TRUE(truth.status.ok()) << truth.status.message;
    const double error = std::hypot(truth.x - line.x, truth.y - line.y);
    EXPECT_NEAR(line.estimated_error, error, 0.05 * error) << length;
  }
  const CableSolution slack = findForces(steelRope(), 9.5, 8.0, -4.0, options(Model::kStraightElastic));
  EXPECT_NEAR(slack.estimated_error, std::hypot(8.0, 4.0), 1e-9);  // both ends of what hangs there side by side
  EXPECT_FALSE(slack.error_known);
}

}  // namespace
}  // namespace cdpr_kinetostatics
