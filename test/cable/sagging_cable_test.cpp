// The properties that a cable of every model has, one suite for all; each model is one line at the end. They speak of
// the three problems and of the cable that robots hold, never of how a model is solved.
#include "cable/sagging_cable.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "known_cables.h"
#include "random_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kCables = 30;
constexpr double kTolerance = 1e-11;

// A property of the cable in whose limit the model becomes another one.
enum class Vanishing { kBendingStiffness, kCompliance, kWeight };

struct Limit {
  Vanishing vanishing;
  Model neighbour;
  double order;  // of the difference of the ends, in what vanishes
};

struct ModelCase {
  Model model;
  std::vector<Limit> limits;
  double moment_error = 1e-6;  // of the balance of moments, relative to T_A L: quadrature, or the model's own error
};

void PrintTo(const ModelCase& c, std::ostream* out) { *out << modelName(c.model); }

class EveryModel : public ::testing::TestWithParam<ModelCase> {
 protected:
  Model model() const { return GetParam().model; }

  CableSolverOptions options(int profile_points = 0) const { return optionsOf(model(), profile_points); }

  static CableSolverOptions optionsOf(Model model, int profile_points = 0) {
    CableSolverOptions result;
    result.model = model;
    result.tolerance = kTolerance;
    result.profile_points = profile_points;
    return result;
  }

  // Taut and sagging cables of moderate bending, each with forces at A that pull, so that every model has an answer.
  static std::vector<CableCase> cables() {
    RandomCables random;
    random.fewest_layers = 30.0;
    random.least_strain = 1e-4;
    random.most_slack = 1.3;
    random.steepest = 1.2;
    std::vector<CableCase> result;
    for (int k = 0; k < kCables; ++k) result.push_back(random.next());
    return result;
  }

  // Forces at A of a cable whose line from A to B carries four times its weight, or what makes the cable thirty bending
  // layers long: given, not solved for.
  static ForcesAtA pullOf(const CableCase& c) {
    const double tension =
        std::max(4.0 * c.cable.weight * c.length, c.cable.bending_stiffness * std::pow(30.0 / c.length, 2));
    return {tension * c.x / c.chord(), 0.5 * c.cable.weight * c.length - tension * c.y / c.chord()};
  }

  CableSolution under(const CableCase& c, const ForcesAtA& forces) const {
    const CableSolution s = findPosition(c.cable, c.length, forces.horizontal, forces.vertical, options());
    EXPECT_TRUE(s.status.ok()) << c << ": " << s.status.message;
    return s;
  }
};

TEST_P(EveryModel, AnswersItsThreeProblemsAlike) {
  for (const CableCase& c : cables()) {
    SCOPED_TRACE(::testing::Message() << c);
    const ForcesAtA forces = pullOf(c);
    const CableSolution position = under(c, forces);
    const double tension = forces.tension();
    const CableSolution length = findLength(c.cable, position.x, position.y, tension, c.length, options());
    ASSERT_TRUE(length.status.ok()) << length.status.message;
    // Near a fold of T_A(L) the length is worth half of the digits of the tension.
    EXPECT_NEAR(length.length, c.length, 1e-5 * c.length);
    EXPECT_NEAR(length.tension_a, tension, 1e-6 * tension);
    if (model() == Model::kStraight) continue;  // its forces do not follow from its ends
    const CableSolution back = findForces(c.cable, c.length, position.x, position.y, options());
    ASSERT_TRUE(back.status.ok()) << back.status.message;
    // An end known to rounding fixes the forces of a stiff cable to rounding times its stiffness.
    const double exact = 1e-8 * tension + 1e-13 * c.length * back.force_jacobian.norm();
    EXPECT_NEAR(back.horizontal_force, forces.horizontal, exact);
    EXPECT_NEAR(back.vertical_force_a, forces.vertical, exact);
  }
}

// The linearisation that robots take, against differences of fourth order of problem 1.
TEST_P(EveryModel, IsLinearisedWithTheDerivativesOfItsEnd) {
  for (const CableCase& c : cables()) {
    SCOPED_TRACE(::testing::Message() << c);
    const ForcesAtA forces = pullOf(c);
    SaggingCable cable(c.cable, model(), kTolerance);
    ASSERT_TRUE(cable.startUnder(c.length, forces, {kTolerance}).ok());
    ASSERT_TRUE(cable.linearise(true));
    const double steps[] = {1e-3 * forces.tension(), 1e-3 * forces.tension(), 1e-3 * c.length};
    for (int column = 0; column < 3; ++column) {
      const auto end = [&](double share) -> Eigen::Vector2d {
        double input[] = {forces.horizontal, forces.vertical, c.length};
        input[column] += share * steps[column];
        const CableSolution s = findPosition(c.cable, input[2], input[0], input[1], options());
        EXPECT_TRUE(s.status.ok()) << s.status.message;
        return {s.x, s.y};
      };
      const Eigen::Vector2d difference =
          (8.0 * (end(1.0) - end(-1.0)) - (end(2.0) - end(-2.0))) / (12.0 * steps[column]);
      const Eigen::Vector2d computed = cable.end().jacobian.col(column);
      EXPECT_LT((computed - difference).norm(), 1e-7 * computed.norm() + 1e-11 * c.length / steps[column])
          << "column " << column << ": " << computed.transpose() << " but " << difference.transpose();
    }
  }
}

// Steps of the cable that a robot holds end where problem 1 says that it ends.
TEST_P(EveryModel, EndsAfterStepsWhereItEndsUnderTheSameForces) {
  for (const CableCase& c : cables()) {
    SCOPED_TRACE(::testing::Message() << c);
    const ForcesAtA forces = pullOf(c);
    const Eigen::Vector3d change(0.05 * forces.horizontal, 0.02 * forces.tension(), 1e-3 * c.length);
    SaggingCable cable(c.cable, model(), kTolerance);
    ASSERT_TRUE(cable.startUnder(c.length, forces, {kTolerance}).ok());
    ASSERT_TRUE(cable.linearise(true));
    cable.step(change, 1.0);
    for (int i = 0; i < 6; ++i) {
      ASSERT_TRUE(cable.linearise(i < 3));
      cable.step(Eigen::Vector3d::Zero(), 1.0);
    }
    EXPECT_NEAR(cable.horizontalForce(), forces.horizontal + change.x(), 1e-14 * forces.tension());
    EXPECT_NEAR(cable.verticalForceA(), forces.vertical + change.y(), 1e-14 * forces.tension());
    EXPECT_NEAR(cable.length(), c.length + change.z(), 1e-14 * c.length);
    const CableSolution there =
        findPosition(c.cable, cable.length(), cable.horizontalForce(), cable.verticalForceA(), options());
    ASSERT_TRUE(there.status.ok()) << there.status.message;
    EXPECT_LT((cable.end().position - Eigen::Vector2d(there.x, there.y)).norm(), 1e-8 * c.length);
    EXPECT_TRUE(cable.onBranch());
  }
}

// No moment acts on the ends, so the weight's about A balances that of the force at B: V x + H y = q (L x - int x ds).
TEST_P(EveryModel, BalancesTheMomentsAboutItsEnd) {
  for (const CableCase& c : cables()) {
    SCOPED_TRACE(::testing::Message() << c);
    const ForcesAtA forces = pullOf(c);
    const CableSolution s = findPosition(c.cable, c.length, forces.horizontal, forces.vertical, options(2001));
    ASSERT_TRUE(s.status.ok()) << s.status.message;
    double area = 0.0;
    for (std::size_t i = 1; i < s.profile.size(); ++i) {
      area += 0.5 * (s.profile[i].s - s.profile[i - 1].s) * (s.profile[i].x + s.profile[i - 1].x);
    }
    const double moment = forces.vertical * s.x + forces.horizontal * s.y - c.cable.weight * (c.length * s.x - area);
    EXPECT_LT(std::abs(moment), GetParam().moment_error * forces.tension() * c.length);
  }
}

// In other units it is the same cable: powers of ten for lengths and forces.
TEST_P(EveryModel, IsTheSameCableInOtherUnits) {
  for (const CableCase& c : cables()) {
    const ForcesAtA forces = pullOf(c);
    const CableSolution own = under(c, forces);
    for (const auto& [length, force] : {std::pair(1e3, 1e-3), std::pair(1e-3, 1e3), std::pair(1e3, 1e3)}) {
      SCOPED_TRACE(::testing::Message() << c << ", lengths times " << length << ", forces times " << force);
      const CableProperties cable{c.cable.axial_stiffness * force, c.cable.bending_stiffness * force * length * length,
                                  c.cable.weight * force / length};
      const CableSolution other =
          findPosition(cable, c.length * length, forces.horizontal * force, forces.vertical * force, options());
      ASSERT_TRUE(other.status.ok()) << other.status.message;
      EXPECT_NEAR(other.x / length, own.x, 1e-10 * c.length);
      EXPECT_NEAR(other.y / length, own.y, 1e-10 * c.length);
    }
  }
}

// Where a property vanishes the model passes into its neighbour, and the faster the higher its order says.
TEST_P(EveryModel, PassesIntoItsNeighboursInTheLimit) {
  for (const Limit& limit : GetParam().limits) {
    for (const CableCase& c : cables()) {
      SCOPED_TRACE(::testing::Message() << c << ", towards " << modelName(limit.neighbour));
      const ForcesAtA forces = pullOf(c);
      const auto apart = [&](double share) {
        CableProperties cable = c.cable;
        if (limit.vanishing == Vanishing::kBendingStiffness) cable.bending_stiffness *= share;
        if (limit.vanishing == Vanishing::kCompliance) cable.axial_stiffness /= share;
        if (limit.vanishing == Vanishing::kWeight) cable.weight *= share;
        const auto end = [&](Model model) {
          const CableSolution s = findPosition(cable, c.length, forces.horizontal, forces.vertical, optionsOf(model));
          EXPECT_TRUE(s.status.ok()) << s.status.message;
          return Eigen::Vector2d(s.x, s.y);
        };
        return (end(model()) - end(limit.neighbour)).norm();
      };
      const double far = apart(1e-1);
      const double near = apart(1e-2);
      if (near < 1e-11 * c.length) continue;  // rounding, and the tolerance of integration
      EXPECT_NEAR(std::log10(far / near), limit.order, 0.25);
    }
  }
}

constexpr Vanishing kEI = Vanishing::kBendingStiffness;
constexpr Vanishing kEA = Vanishing::kCompliance;
constexpr Vanishing kQ = Vanishing::kWeight;

using ::testing::Values;
INSTANTIATE_TEST_SUITE_P(Straight, EveryModel, Values(ModelCase{Model::kStraight, {}}));
INSTANTIATE_TEST_SUITE_P(StraightElastic, EveryModel,
                         Values(ModelCase{Model::kStraightElastic, {{kEA, Model::kStraight, 1.0}}}));
INSTANTIATE_TEST_SUITE_P(CatenaryInextensible, EveryModel,
                         Values(ModelCase{Model::kCatenaryInextensible, {{kQ, Model::kStraight, 2.0}}}));
INSTANTIATE_TEST_SUITE_P(Catenary, EveryModel,
                         Values(ModelCase{
                             Model::kCatenary,
                             {{kEA, Model::kCatenaryInextensible, 1.0}, {kQ, Model::kStraightElastic, 2.0}}}));
INSTANTIATE_TEST_SUITE_P(CatenaryCorrected, EveryModel,
                         Values(ModelCase{Model::kCatenaryCorrected, {{kEI, Model::kCatenary, 1.0}}, 1e-3}));
INSTANTIATE_TEST_SUITE_P(BendingInextensible, EveryModel,
                         Values(ModelCase{Model::kBendingInextensible, {{kEI, Model::kCatenaryInextensible, 1.0}}}));
INSTANTIATE_TEST_SUITE_P(Bending, EveryModel,
                         Values(ModelCase{Model::kBending,
                                          {{kEA, Model::kBendingInextensible, 1.0},
                                           {kEI, Model::kCatenary, 1.0},
                                           {kEI, Model::kCatenaryCorrected, 1.5}}}));

}  // namespace
}  // namespace cdpr_kinetostatics
