// Cables are evaluated without the heap once they have been evaluated before.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <memory>
#include <ostream>

#include "cable/catenary.h"
#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/residuals/cable_closure.h"
#include "counted_allocations.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

// A cable of length 8.2 m (or as given) whose end moves around (x, y).
struct MovingCable {
  const char* name;
  CableProperties properties;
  double length, x, y;
};

void PrintTo(const MovingCable& cable, std::ostream* out) { *out << cable.name; }

const MovingCable kCables[] = {
    {"steelRope", steelRope(), 8.2, 7.0, -4.0},
    {"slackSteelRope", steelRope(), 11.0, 7.0, -4.0},
    {"musicWire", {3.53e5, 0.0497, 0.136}, 0.66, 0.5, -0.4},
    {"paperBar", paperBar(), 5.65, 5.0, -2.5},
    {"ropeOnPulley", {2.87e5, 0.01, 0.628, {0.1, RopeFrom::kBelow}, 5.0}, 8.6, 7.0, -4.0},
};

constexpr int kEnds = 24;

// Ends on a circle of 1 % of the length around where the cable is; in every round others.
double turnAt(int i, int round) { return 2.0 * kPi * (i + 0.5 * round) / kEnds; }

Eigen::Vector2d endAt(const MovingCable& cable, double turn) {
  return Eigen::Vector2d(cable.x, cable.y) + 0.01 * cable.length * Eigen::Vector2d(std::cos(turn), std::sin(turn));
}

class Allocation : public ::testing::TestWithParam<MovingCable> {};

TEST(CountedAllocations, AreSeen) {
  const HeapCount before = heapCount();
  {
    const std::unique_ptr<int> owned(new int(1));
    const Eigen::VectorXd aligned = Eigen::VectorXd::Zero(100);
    EXPECT_EQ(heapCount().allocations, before.allocations + 2) << *owned << aligned.sum();
    EXPECT_GE(heapCount().bytes, before.bytes + 804);
  }
  EXPECT_EQ(heapCount().bytes, before.bytes);
}

// Newton's method towards ends that move: steps chosen anew, and repeated.
TEST_P(Allocation, LinearisingACableAgainTakesNothing) {
  const MovingCable& c = GetParam();
  for (const Model model : {Model::kStraightElastic, Model::kCatenary, Model::kBendingInextensible, Model::kBending}) {
    if (model == Model::kStraightElastic && c.length > std::hypot(c.x, c.y)) continue;
    SCOPED_TRACE(modelName(model));
    SaggingCable cable(c.properties, model, 1e-8);
    ASSERT_TRUE(cable.startBetween(c.length, c.x, c.y, {}).ok());
    long allocations = 0;
    for (int round = 0; round < 2; ++round) {
      allocations = heapCount().allocations;
      for (int i = 0; i < kEnds; ++i) {
        const Eigen::Vector2d goal = endAt(c, turnAt(i, round));
        for (int iteration = 0; iteration < 8; ++iteration) {
          ASSERT_TRUE(cable.linearise(iteration < 4));
          const EndPoint& end = cable.end();
          Eigen::Vector3d change = Eigen::Vector3d::Zero();
          change.head<2>() = end.jacobian.leftCols<2>().inverse() * (goal - end.position);
          cable.step(change, cable.dampingFor(change));
        }
        ASSERT_TRUE(cable.linearise(false));
        EXPECT_LT((cable.end().position - goal).norm(), 1e-6 * c.length);
        EXPECT_TRUE(cable.onBranch());
      }
    }
    EXPECT_EQ(heapCount().allocations, allocations) << "in the second round";
  }
}

TEST_P(Allocation, EvaluatingAResidualBlockAgainTakesNothing) {
  const MovingCable& c = GetParam();
  SaggingCable known(c.properties, Model::kBending, 1e-8);
  ASSERT_TRUE(known.startBetween(c.length, c.x, c.y, {}).ok());
  for (const Model model : {Model::kCatenary, Model::kBending}) {
    SCOPED_TRACE(modelName(model));
    const auto closure =
        makeClosure(model, c.properties, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), c.length, {1e-8});
    double residuals[2];
    double blocks[4][8];
    double* jacobians[] = {blocks[0], blocks[1], blocks[2], blocks[3]};
    long allocations = 0;
    for (int round = 0; round < 2; ++round) {
      allocations = heapCount().allocations;
      for (int i = 0; i < kEnds; ++i) {
        const double turn = turnAt(i, round);
        const Eigen::Vector2d end = endAt(c, turn);
        const double share = 0.01 * std::sin(turn);
        const double position[] = {end.x(), 0.0, end.y()};
        const double orientation[] = {0.0, 0.0, 0.0, 1.0};
        const double force[] = {known.horizontalForce() / end.x() * (1.0 + share), known.verticalForceA()};
        const double length[] = {c.length * (1.0 + 1e-3 * share)};
        const double* const parameters[] = {position, orientation, force, length};
        const bool evaluated = closure->Evaluate(parameters, residuals, jacobians);
        ASSERT_TRUE(evaluated || (model == Model::kCatenary && known.horizontalForce() < 0.0));
      }
    }
    EXPECT_EQ(heapCount().allocations, allocations) << "in the second round";
  }
}

INSTANTIATE_TEST_SUITE_P(Cables, Allocation, ::testing::ValuesIn(kCables));

}  // namespace
}  // namespace cdpr_kinetostatics
