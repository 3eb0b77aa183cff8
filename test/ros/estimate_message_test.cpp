#include "ros/estimate_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {
namespace {

class EstimateMessage : public testing::Test {
 protected:
  EstimateMessage() {
    robot_.home.position = {1.0, 2.0, 3.0};
    estimate_.solution.report.status.code = Code::kConverged;
    estimate_.solution.pose.position = {4.0, 5.0, 6.0};
    estimate_.solution.pose.orientation = Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0);
    estimate_.solution.cables.resize(2);
    estimate_.covariance(0, 5) = 0.25;
    estimate_.load << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
    estimate_.length_residual = {0.1, -0.2};
    estimate_.tension_residual = {10.0, 20.0};
    estimate_.length_outlier = {true, false};
    estimate_.tension_outlier = {false, false};
    estimate_.length_suspect = estimate_.tension_suspect = {false, false};
    measurement_.header.stamp = ros::Time(12, 34);
    measurement_.header.frame_id = "whatever the drives say";
    measurement_.cables.lengths.resize(2);
    measurement_.cables.tensions = {50.0, std::nullopt};
  }

  KinetostaticState state() const { return toMsg(estimate_, measurement_, robot_, "world"); }

  RobotDescription robot_;
  Estimate estimate_;
  Measurement measurement_;
};

TEST_F(EstimateMessage, IsStampedAsTheMeasurementInTheBaseFrame) {
  EXPECT_EQ(state().header.stamp, ros::Time(12, 34));
  EXPECT_EQ(state().header.frame_id, "world");
}

TEST_F(EstimateMessage, HoldsPoseLoadAndResiduals) {
  EXPECT_EQ(state().report.code, SolveReport::CONVERGED);
  EXPECT_EQ(state().pose.pose.position.y, 5.0);
  EXPECT_EQ(state().pose.pose.orientation.y, 0.6);
  EXPECT_EQ(state().pose.covariance[5], 0.25);  // row 0, column 5
  EXPECT_EQ(state().load.force.z, 3.0);
  EXPECT_EQ(state().load.torque.x, 4.0);
  EXPECT_EQ(state().length_residual, (std::vector<double>{0.1, -0.2}));
  EXPECT_EQ(state().tension_residual, (std::vector<double>{10.0, 20.0}));
  ASSERT_EQ(state().outlier.size(), 2u);
  EXPECT_TRUE(state().outlier[0]);
  EXPECT_FALSE(state().outlier[1]);
  estimate_.tension_suspect[1] = true;
  EXPECT_TRUE(state().outlier[1]);
}

TEST_F(EstimateMessage, HasNoResidualsOfTensionsThatNobodyMeasured) {
  measurement_.cables.tensions = {std::nullopt, std::nullopt};
  EXPECT_TRUE(state().tension_residual.empty());
  EXPECT_EQ(state().length_residual.size(), 2u);
}

TEST_F(EstimateMessage, WithoutEstimateIsAtHomeWithUnknownCovariance) {
  estimate_.solution.report.status = {Code::kNotConverged, "no pose explains the measurements"};
  const KinetostaticState failed = state();
  EXPECT_EQ(failed.report.message, "no pose explains the measurements");
  EXPECT_EQ(failed.pose.pose.position.z, 3.0);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(failed.pose.covariance[7 * i], kUnknownVariance);
  EXPECT_TRUE(failed.cables.empty());
}

TEST_F(EstimateMessage, NeverHoldsANumberThatIsNotFinite) {
  estimate_.load(3) = std::numeric_limits<double>::quiet_NaN();
  const KinetostaticState failed = state();
  EXPECT_EQ(failed.report.code, SolveReport::INTERNAL_ERROR);
  EXPECT_EQ(failed.load.torque.x, 0.0);
  EXPECT_EQ(failed.pose.pose.position.x, 1.0);
}

TEST_F(EstimateMessage, PoseLoadAndTransformAreThatOfTheState) {
  const KinetostaticState whole = state();
  EXPECT_EQ(poseOf(whole).header, whole.header);
  EXPECT_EQ(poseOf(whole).pose, whole.pose);
  EXPECT_EQ(loadOf(whole).wrench, whole.load);
  const geometry_msgs::TransformStamped transform = transformOf(whole, "platform");
  EXPECT_EQ(transform.header.frame_id, "world");
  EXPECT_EQ(transform.child_frame_id, "platform");
  EXPECT_EQ(transform.transform.translation.z, 6.0);
  EXPECT_EQ(transform.transform.rotation, whole.pose.pose.orientation);
}

}  // namespace
}  // namespace cdpr_kinetostatics
