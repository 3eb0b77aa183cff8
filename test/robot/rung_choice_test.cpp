// AUTO's choice of models from given effects, and along a path.
#include "robot/rung_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

TEST(RungChoice, KeepsARungThatTheCoarserOneWouldOnlyJustReplace) {
  // One cable's catenary moves the platform by `effect`; AUTO may neglect half the accuracy.
  const auto chosen = [](double effect, const std::vector<Model>& kept) {
    RungEffects cable;
    for (Wrench& displacement : cable.displacement) displacement.setZero();
    cable.displacement[0].x() = 1.0;
    cable.displacement[1].x() = effect;
    cable.known.fill(true);
    return RungChoice().choose(std::vector<RungEffects>{cable}, 1e-4, kept).front();
  };
  EXPECT_EQ(chosen(3e-5, {}), Model::kCatenary);
  EXPECT_EQ(chosen(6e-5, {}), Model::kCatenaryCorrected);
  EXPECT_EQ(chosen(3e-5, {Model::kCatenaryCorrected}), Model::kCatenaryCorrected);
  EXPECT_EQ(chosen(1e-5, {Model::kCatenaryCorrected}), Model::kCatenary);
  EXPECT_EQ(chosen(6e-5, {Model::kCatenary}), Model::kCatenaryCorrected);
}

TEST(RungChoice, NeverUsesARungWhoseErrorIsNotKnown) {
  RungEffects cable;
  for (Wrench& displacement : cable.displacement) displacement.setZero();
  cable.known = {false, false, true, true};
  EXPECT_EQ(RungChoice().choose(std::vector<RungEffects>{cable}, 1.0, {}).front(), Model::kCatenaryCorrected);
}

// Each rung's effect is a tenth of the one before.
std::vector<RungEffects> randomEffects(Dice* dice) {
  std::vector<RungEffects> cables(8);
  for (RungEffects& cable : cables) {
    double size = std::pow(10.0, dice->uniform(-6.0, -3.0));
    for (Wrench& displacement : cable.displacement) {
      displacement << size * dice->direction(), 0.3 * size * dice->direction();
      size *= 0.1;
    }
    cable.displacement.back().setZero();
    cable.known.fill(true);
  }
  return cables;
}

TEST(RungChoice, TheSumOfTheEffectsStaysWithinHalfTheAccuracy) {
  Dice dice(71);
  for (int i = 0; i < 50; ++i) {
    const std::vector<RungEffects> cables = randomEffects(&dice);
    RungChoice choice;
    std::vector<Model> finer(cables.size(), Model::kStraightElastic);
    for (const double accuracy : {1e-2, 1e-4, 1e-6}) {
      const std::vector<Model> chosen = choice.choose(cables, accuracy, {});
      Wrench total = Wrench::Zero();
      for (std::size_t k = 0; k < cables.size(); ++k) {
        const auto rung = std::find(kAutoRungs.begin(), kAutoRungs.end(), chosen[k]) - kAutoRungs.begin();
        total += cables[k].displacement[rung];
        EXPECT_GE(chosen[k], finer[k]) << "more accuracy takes no coarser model";
      }
      EXPECT_LE(total.head<3>().norm(), 0.5 * accuracy);
      EXPECT_LE(total.tail<3>().norm(), 0.5 * accuracy);
      finer = chosen;
    }
  }
}

TEST(RungChoice, RefinesEveryModelThatHasAFinerOne) {
  std::vector<Model> rungs = {Model::kStraightElastic, Model::kCatenary, Model::kCatenaryCorrected, Model::kBending};
  EXPECT_TRUE(refineRungs(&rungs));
  EXPECT_EQ(rungs, (std::vector<Model>{Model::kCatenary, Model::kCatenaryCorrected, Model::kBending, Model::kBending}));
  rungs.assign(4, Model::kBending);
  EXPECT_FALSE(refineRungs(&rungs));
}

class RungsOfCogiro : public testing::Test {
 protected:
  RungsOfCogiro() {
    const RobotSolution at = solveInverse(robot_, requestFor(robot_, robot_.home), patient(Model::kCatenary, 1e-10));
    EXPECT_TRUE(at.report.status.ok());
    state_.pose = at.pose;
    for (const CableResult& result : at.cables) {
      state_.lengths.push_back(result.cable.length);
      state_.forces.push_back({result.cable.horizontal_force, result.cable.vertical_force_a});
    }
  }

  RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  RobotForces state_;
};

TEST_F(RungsOfCogiro, CoarserModelsDoForLessAccuracy) {
  RungChoice choice;
  const std::vector<Model> coarse = choice.choose(robot_, state_, 1.0, {});
  EXPECT_EQ(coarse, std::vector<Model>(8, Model::kStraightElastic));
  const std::vector<Model> fine = choice.choose(robot_, state_, 1e-15, {});
  EXPECT_EQ(fine, std::vector<Model>(8, Model::kBending));
}

TEST_F(RungsOfCogiro, EveryCableBendsWhereTheRobotHasNoStiffness) {
  for (CableDescription& cable : robot_.cables) cable = robot_.cables.front();
  state_.lengths.assign(8, state_.lengths.front());
  state_.forces.assign(8, state_.forces.front());
  robot_.com.setZero();
  for (CableDescription& cable : robot_.cables) cable.attachment.setZero();  // nothing resists a turn
  EXPECT_EQ(RungChoice().choose(robot_, state_, 1.0, {}), std::vector<Model>(8, Model::kBending));
}

TEST_F(RungsOfCogiro, APathLeavesModelsThatAreTooCoarseAtOnceAndTooFineOnesAfterAWhile) {
  RungChoice choice;
  EXPECT_FALSE(choice.serve(robot_, state_, 1e-15, std::vector<Model>(8, Model::kCatenary)));
  EXPECT_TRUE(choice.serve(robot_, state_, 1e-15, std::vector<Model>(8, Model::kBending)));
  int served = 0;
  while (served < 1000 && choice.serve(robot_, state_, 1.0, std::vector<Model>(8, Model::kBending))) ++served;
  EXPECT_EQ(served, 50);
  EXPECT_TRUE(choice.serve(robot_, state_, 1.0, std::vector<Model>(8, Model::kStraightElastic)));
}

}  // namespace
}  // namespace cdpr_kinetostatics
