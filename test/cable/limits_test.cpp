// How the models pass into one another as a stiffness or the weight vanishes or grows, and the symmetries of
// the problem: scale, and which end is called A.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <utility>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"
#include "random_cables.h"

namespace cdpr_kinetostatics {
namespace {

CableSolverOptions options(Model model, double tolerance = 1e-12) {
  CableSolverOptions result;
  result.model = model;
  result.tolerance = tolerance;
  return result;
}

Eigen::Vector2d forces(const CableSolution& s) { return {s.horizontal_force, s.vertical_force_a}; }
Eigen::Vector2d end(const CableSolution& s) { return {s.x, s.y}; }

// Order of error(parameter) between two values of it.
double order(const std::function<double(double)>& error, double a, double b) {
  return std::log(error(a) / error(b)) / std::log(a / b);
}

TEST(Limits, BendingTendsToTheCatenaryInProportionToEI) {
  for (const double length : {7.0, 8.5, 14.0}) {  // taut, sagging, slack; chord 8.06
    const double stretched = length < 8.0 ? 8.06 : length;
    CableProperties rope = steelRope();
    const CableSolution catenary = findForces(rope, stretched, 7.0, -4.0, options(Model::kCatenary));
    ASSERT_TRUE(catenary.status.ok());
    const auto error = [&](double stiffness) {
      rope.bending_stiffness = stiffness;
      const CableSolution s = findForces(rope, stretched, 7.0, -4.0, options(Model::kBending));
      EXPECT_TRUE(s.status.ok()) << s.status.message;
      return (forces(s) - forces(catenary)).norm();
    };
    EXPECT_NEAR(order(error, 1e-5, 1e-6), 1.0, 0.02) << "L " << stretched;
    EXPECT_NEAR(order(error, 1e-3, 1e-4), 1.0, 0.05) << "L " << stretched;
  }
}

TEST(Limits, WithoutBendingStiffnessBendingIsTheCatenary) {
  CableProperties rope = steelRope();
  rope.bending_stiffness = 0.0;
  const CableSolution bending = findForces(rope, 8.5, 7.0, -4.0, options(Model::kBending));
  const CableSolution catenary = findForces(rope, 8.5, 7.0, -4.0, options(Model::kCatenary));
  ASSERT_TRUE(bending.status.ok()) << bending.status.message;
  EXPECT_EQ(bending.model, Model::kBending);
  EXPECT_EQ(forces(bending), forces(catenary));
}

TEST(Limits, ElasticTendsToInextensibleInProportionToItsCompliance) {
  for (const bool bending : {false, true}) {
    CableProperties rope = steelRope();
    const Model stiff = bending ? Model::kBendingInextensible : Model::kCatenaryInextensible;
    const CableSolution limit = findPosition(rope, 8.0, 20.0, 5.0, options(stiff));
    ASSERT_TRUE(limit.status.ok()) << limit.status.message;
    const auto error = [&](double compliance) {
      rope.axial_stiffness = 1.0 / compliance;
      const CableSolution s = findPosition(rope, 8.0, 20.0, 5.0, options(bending ? Model::kBending : Model::kCatenary));
      EXPECT_TRUE(s.status.ok()) << s.status.message;
      return (end(s) - end(limit)).norm();
    };
    EXPECT_NEAR(order(error, 1e-6, 1e-7), 1.0, 1e-3) << (bending ? "bending" : "catenary");
  }
}

TEST(Limits, AnInfiniteAxialStiffnessIsTheInextensibleRung) {
  CableProperties rope = steelRope();
  rope.axial_stiffness = std::numeric_limits<double>::infinity();
  const CableSolution infinite = findForces(rope, 8.5, 7.0, -4.0, options(Model::kBending));
  const CableSolution rung = findForces(rope, 8.5, 7.0, -4.0, options(Model::kBendingInextensible));
  ASSERT_TRUE(infinite.status.ok()) << infinite.status.message;
  EXPECT_EQ(forces(infinite), forces(rung));
  EXPECT_EQ(infinite.strained_length, 8.5);
}

TEST(Limits, WithoutWeightATautCableIsStraight) {
  for (const CableProperties& cable : {steelRope(), paperBar()}) {
    const double length = 5.0 / 1.0005;
    for (const Model model : {Model::kCatenary, Model::kBending}) {
      double last = 0.0;
      for (const double weight : {1e-1, 1e-2, 1e-3, 0.0}) {
        CableProperties light = cable;
        light.weight = weight;
        const CableSolution straight = findForces(light, length, 3.0, 4.0, options(Model::kStraightElastic));
        const CableSolution s = findForces(light, length, 3.0, 4.0, options(model));
        ASSERT_TRUE(s.status.ok()) << s.status.message;
        const double error = (forces(s) - forces(straight)).norm() / s.tension_a;
        if (last > 0.0) {
          EXPECT_LT(error, 0.02 * last + 1e-11) << modelName(model) << ", q " << weight;
        }
        if (weight == 0.0) {
          EXPECT_NEAR(s.sag, 0.0, 1e-10);
          EXPECT_NEAR(s.angle_a, std::atan2(4.0, 3.0), 1e-10);
        }
        last = error;
      }
    }
  }
}

// Lengths times a, forces times b: the same cable.
TEST(Symmetries, ScaleChangesNothing) {
  RandomCables random;
  random.fewest_layers = 0.5;
  for (int i = 0; i < 60; ++i) {
    const CableCase c = random.next();
    const CableSolution s = findForces(c.cable, c.length, c.x, c.y, options(Model::kBending, 1e-9));
    ASSERT_TRUE(s.status.ok()) << c << ": " << s.status.message;
    for (const auto& [a, b] : {std::pair(1e-3, 1e5), std::pair(300.0, 1e-4)}) {
      const CableProperties scaled{c.cable.axial_stiffness * b, c.cable.bending_stiffness * a * a * b,
                                   c.cable.weight * b / a};
      const CableSolution t = findForces(scaled, c.length * a, c.x * a, c.y * a, options(Model::kBending, 1e-9));
      ASSERT_TRUE(t.status.ok()) << c << ", lengths times " << a << ": " << t.status.message;
      EXPECT_LT((forces(t) / b - forces(s)).norm(), 1e-8 * s.tension_a) << c << ", lengths times " << a;
      EXPECT_NEAR(t.sag / a, s.sag, 1e-8 * c.length) << c << ", lengths times " << a;
    }
  }
}

// Seen from B the same cable leads to (x, -y), and what held its one end now holds the other.
TEST(Symmetries, EitherEndMayBeCalledA) {
  RandomCables random;
  random.fewest_layers = 0.5;
  for (int i = 0; i < 100; ++i) {
    const CableCase c = random.next();
    const CableSolution s = findForces(c.cable, c.length, c.x, c.y, options(Model::kBending, 1e-10));
    const CableSolution t = findForces(c.cable, c.length, c.x, -c.y, options(Model::kBending, 1e-10));
    ASSERT_TRUE(s.status.ok() && t.status.ok()) << c << ": " << s.status.message << t.status.message;
    EXPECT_NEAR(t.horizontal_force, s.horizontal_force, 1e-8 * s.tension_a) << c;
    EXPECT_NEAR(t.vertical_force_a, c.cable.weight * c.length - s.vertical_force_a, 1e-8 * s.tension_a) << c;
    EXPECT_NEAR(t.angle_a, -s.angle_b, 1e-7) << c;
    EXPECT_NEAR(t.strained_length, s.strained_length, 1e-9 * c.length) << c;
    EXPECT_NEAR(t.sag, s.sag, 1e-8 * c.length) << c;
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics
