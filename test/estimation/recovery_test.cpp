// After whatever was sent, good messages bring the answer of an estimator without a past.
#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "hostile_messages.h"

namespace cdpr_kinetostatics {
namespace {

// What the property allows; far more than an adjustment takes.
constexpr int kGood = 10;

class Recovery : public testing::TestWithParam<std::string> {};

TEST_P(Recovery, FollowsAnySequenceOfHostileMessages) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, GetParam());
  simulated.estimator.timeout = std::chrono::duration<double>(0.1);  // the default: hostile messages may use it up
  const Workspace workspace = workspaceOf(GetParam());
  Dice dice(11);
  PoseEstimator estimator(simulated.robot, simulated.estimator);  // one for all: each sequence inherits the ones before
  for (int sequence = 0; sequence < 100;) {
    if (!simulated.moveTo(randomPose(workspace, &simulated.dice))) continue;
    ++sequence;
    const CableMeasurements good = simulated.measure(simulated.truth, 0.0);
    mistreat(simulated, good, &dice, &estimator);
    Estimate last;
    for (int k = 0; k < kGood; ++k) last = estimator.update(good);
    const Estimate fresh = PoseEstimator(simulated.robot, simulated.estimator).update(good);
    ASSERT_EQ(last.solution.report.status.code, fresh.solution.report.status.code)
        << sequence << ": " << last.solution.report.status.message;
    const Wrench error = poseError(last.solution.pose, fresh.solution.pose);
    EXPECT_LT(error.head(simulated.robot.freedoms()).norm(), 1e-6) << sequence;  // a point mass has no attitude
    EXPECT_EQ(last.length_outlier, fresh.length_outlier) << sequence;
    EXPECT_EQ(last.tension_outlier, fresh.tension_outlier) << sequence;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Recovery,
                         testing::Values("cogiro", "ipanema3", "caroca", "desktop_music_wire", "scampi",
                                         "paper_point_mass", "fast"),
                         [](const auto& robot) { return robot.param; });

CableMeasurements message(const std::vector<double>& lengths, const std::vector<double>& tensions) {
  return {{lengths.begin(), lengths.end()}, {tensions.begin(), tensions.end()}};
}

// Swapped lengths, tensions of nonsense, no numbers at all: an estimator that trusted its last pose took three right
// lengths for faulty ever after.
TEST(RecoveryOfCoGiRo, FollowsThreeMessagesThatHeldItInAWrongPose) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "cogiro");
  const std::vector<double> exact = {9.57454404,  8.977896853, 9.599571996, 9.606728284,
                                     10.04324978, 9.484288647, 9.45317848,  9.507761037};
  const std::vector<double> nan(8, std::numeric_limits<double>::quiet_NaN());
  for (const Model model : {Model::kCatenary, Model::kBending, Model::kAuto}) {
    EstimatorOptions options;
    options.model = model;
    options.load_stddev = EstimatorOptions::defaultLoadStddev(robot);
    options.timeout = std::chrono::seconds(1);  // which one of the bad messages uses up
    PoseEstimator estimator(robot, options);
    static_cast<void>(estimator.update(
        message({9.572856529, 10.36226032, 9.519963735, 9.5463946, 11.87916209, 8.906569599, 8.867131312, 10.16864433},
                {450.9, 333.9, 272.5, 382.7, 400.9, 322.9, 275.4, 423.5})));
    static_cast<void>(
        estimator.update(message(exact, {-41437.0, -249282.0, 0.0045, -7125759.0, 0.071, 1.6e11, 1.76e11, -0.78})));
    static_cast<void>(estimator.update(message(nan, nan)));
    // The tensions that belong to those lengths, from an adjustment of the lengths alone.
    CableMeasurements good = message(exact, nan);
    for (auto& tension : good.tensions) tension.reset();
    const Estimate by_lengths = PoseEstimator(robot, options).update(good);
    ASSERT_TRUE(by_lengths.solution.report.status.ok());
    for (std::size_t i = 0; i < 8; ++i) good.tensions[i] = by_lengths.solution.cables[i].cable.tension_a;
    Estimate last;
    for (int k = 0; k < kGood; ++k) last = estimator.update(good);
    ASSERT_TRUE(last.solution.report.status.ok()) << last.solution.report.status.message;
    EXPECT_LT((last.solution.pose.position - Eigen::Vector3d(-0.0886, -0.3031, 1.8154)).norm(), 5e-4);
    EXPECT_EQ(last.length_outlier, std::vector<bool>(8, false));
  }
}

// A seed that is turned by 135 degrees or more.
TEST(RecoveryOfCoGiRo, FollowsASeedThatIsTurnedOver) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "cogiro");
  const CableMeasurements good = simulated.measure(simulated.truth, 0.0);
  for (const Eigen::Vector3d axis : {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()}) {
    for (const double degrees : {135.0, 160.0, 180.0, 225.0}) {
      PoseEstimator estimator(simulated.robot, simulated.estimator);
      Pose seed = simulated.robot.home;
      seed.orientation = Eigen::AngleAxisd(degrees * M_PI / 180.0, axis);
      estimator.setPose(seed);
      Estimate last;
      for (int k = 0; k < kGood; ++k) last = estimator.update(good);
      ASSERT_TRUE(last.solution.report.status.ok()) << last.solution.report.status.message;
      EXPECT_LT(poseError(last.solution.pose, simulated.truth.pose).norm(), 1e-6) << degrees << " " << axis.transpose();
    }
  }
}

// From home the springs turn the platform over on the way to these poses, and some of the measurements fit there.
TEST(RecoveryOfIPAnema, AFreshStartDoesNotEndOnItsHead) {
  SimulatedRobot simulated = simulatedRobot(ROBOT_DIR, "ipanema3");
  for (const Pose& pose : {Pose{{2.2672, -0.7453, 1.7920}, {0.99999, 0.00038, -0.00183, 0.00341}},
                           Pose{{2.2227, 0.9973, 1.7910}, {0.99978, 0.02080, -0.00190, -0.00167}},
                           Pose{{2.0857, 0.9080, 1.7285}, {0.99999, 0.00307, 0.00340, -0.00017}}}) {
    ASSERT_TRUE(simulated.moveTo({pose.position, pose.orientation.normalized()}));
    PoseEstimator estimator(simulated.robot, simulated.estimator);
    const Estimate estimate = estimator.update(simulated.measure(simulated.truth, 0.0));
    ASSERT_TRUE(estimate.solution.report.status.ok()) << estimate.solution.report.status.message;
    EXPECT_LT(poseError(estimate.solution.pose, simulated.truth.pose).norm(), 1e-6) << pose.position.transpose();
    EXPECT_EQ(estimate.redundancy, 8);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics
