// A cable closed exactly at a pose: its end is where it should be, and its derivatives are those of differences.
#include "residuals/closed_cable.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "geometry/spatial.h"
#include "robot_closure_states.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kStates = 10;
constexpr double kTolerance = 1e-11;

class EveryModelClosed : public testing::TestWithParam<std::tuple<Model, bool>> {
 protected:
  // A state near closure, its start included.
  struct Start {
    ClosureState state;
    Pose pose;
    double density;
    ClosedCable closed;
  };

  static Model model() { return std::get<0>(GetParam()); }

  Start next() {
    // Taut to deep: the fold, where the tension is least, is among them. On a pulley a deep rope is too stiff to lie.
    const bool pulley = std::get<1>(GetParam());
    const ClosureState s = randomClosure(pulley ? ClosureKind{"pulley", -2e-3, 1e-3, 0.8, -1.0, false, 0.3, 4.0}
                                                : ClosureKind{"any", -1e-3, 0.4, 0.8, -1.0, false},
                                         &dice_);
    Pose pose{Eigen::Vector3d(s.parameters[0]), Eigen::Quaterniond(Eigen::Vector4d(s.parameters[1]))};
    const double density = s.parameters[2](0);
    const double x = cablePlane(s.anchor, s.attachment, pose).x;
    SaggingCable start(s.cable, model(), kTolerance);
    start.start(s.parameters[3](0), {density * x, s.parameters[2](1)});
    return {s, pose, density, ClosedCable(s.anchor, s.attachment, start, {kTolerance})};
  }

 private:
  Dice dice_{51};
};

Eigen::Vector3d stateOf(const ClosedCable& closed) {
  return {closed.cable().horizontalForce(), closed.cable().verticalForceA(), closed.cable().length()};
}

// Problem 1 from the forces and the length found leads to the attachment.
TEST_P(EveryModelClosed, EndsAtTheAttachment) {
  CableSolverOptions options;
  options.model = model();
  options.tolerance = kTolerance;
  int refused = 0;  // cables that bend by more than a first-order effect
  for (int i = 0; i < kStates; ++i) {
    Start start = next();
    ASSERT_TRUE(start.closed.close(start.pose, start.density)) << "state " << i;
    const Eigen::Vector3d found = stateOf(start.closed);
    const CableSolution cable = findPosition(start.state.cable, found.z(), found.x(), found.y(), options);
    if (model() == Model::kCatenaryCorrected && !cable.status.ok()) {
      ASSERT_NE(cable.status.message.find("bending is too large"), std::string::npos) << cable.status.message;
      ++refused;
      continue;
    }
    ASSERT_TRUE(cable.status.ok()) << cable.status.message;
    const Eigen::Vector3d to_b =
        start.pose.position + start.pose.orientation * start.state.attachment - start.state.anchor;
    EXPECT_NEAR(cable.x, to_b.head<2>().norm(), 1e-8 * start.state.chord) << "state " << i;
    EXPECT_NEAR(cable.y, to_b.z(), 1e-8 * start.state.chord) << "state " << i;
    EXPECT_NEAR(found.x(), start.density * to_b.head<2>().norm(), 1e-10 * found.x()) << "state " << i;
    const Eigen::Vector3d force = start.closed.force();
    EXPECT_NEAR(force.z(), found.y() - start.state.cable.weight * cable.free_length, 1e-9 * found.head<2>().norm());
    EXPECT_LT((force.head<2>() + start.density * to_b.head<2>()).norm(), 1e-9 * found.x());
  }
  EXPECT_LT(refused, kStates / 2);
}

TEST_P(EveryModelClosed, HasTheDerivativesOfCentralDifferences) {
  for (int i = 0; i < kStates; ++i) {
    Start start = next();
    ASSERT_TRUE(start.closed.close(start.pose, start.density)) << "state " << i;
    const ClosedCable at = start.closed;
    const Eigen::Vector3d scale(at.cable().tensionA(), at.cable().tensionA(), at.cable().length());
    const auto moved = [&](int axis, double step) {
      ClosedCable closed = at;
      Wrench motion = Wrench::Zero();
      if (axis < 6) motion(axis) = step;
      const Pose pose = displaced(start.pose, motion.head<3>(), motion.tail<3>());
      EXPECT_TRUE(closed.close(pose, axis == 6 ? start.density * (1.0 + step) : start.density));
      return closed;
    };
    for (int axis = 0; axis < 7; ++axis) {
      const double step = 1e-4;
      const ClosedCable more = moved(axis, step), less = moved(axis, -step);
      const ClosedCable most = moved(axis, 2.0 * step), least = moved(axis, -2.0 * step);
      const auto difference = [&](auto value) {
        return Eigen::Vector3d((8.0 * (value(more) - value(less)) - (value(most) - value(least))) / (12.0 * step));
      };
      const double by_density = axis == 6 ? start.density : 1.0;
      const Eigen::Vector3d own = axis == 6 ? Eigen::Vector3d(at.byDensity() * by_density) : at.byPose().col(axis);
      const Eigen::Vector3d numeric = difference(stateOf);
      // The cable to 1e-11, over steps of 1e-4; slopes are up to hundreds of tensions per metre.
      const double size = std::max(1.0, own.cwiseQuotient(scale).norm());
      EXPECT_LT((own - numeric).cwiseQuotient(scale).norm(), 1e-5 * size) << "state " << i << ", axis " << axis;
      const Eigen::Vector3d force =
          axis == 6 ? Eigen::Vector3d(at.forceByDensity() * by_density) : Eigen::Vector3d(at.forceByPose().col(axis));
      const Eigen::Vector3d force_numeric = difference([](const ClosedCable& c) { return c.force(); });
      EXPECT_LT((force - force_numeric).norm(), 1e-5 * size * scale.x()) << "state " << i << ", axis " << axis;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cables, EveryModelClosed,
                         testing::Combine(testing::Values(Model::kCatenaryInextensible, Model::kCatenary,
                                                          Model::kCatenaryCorrected, Model::kBendingInextensible,
                                                          Model::kBending),
                                          testing::Bool()),
                         [](const testing::TestParamInfo<std::tuple<Model, bool>>& each) {
                           return std::string(modelName(std::get<0>(each.param))) +
                                  (std::get<1>(each.param) ? "_on_pulley" : "");
                         });

}  // namespace
}  // namespace cdpr_kinetostatics
