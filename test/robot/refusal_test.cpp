// Requests that cannot be served: what is said about them, how soon, and that no NaN comes out.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Refusals : public testing::Test {
 protected:
  Refusals() {
    const RobotSolution solution = solveInverse(robot_, requestFor(robot_, robot_.home), options_);
    EXPECT_TRUE(solution.report.status.ok());
    forward_.lengths = lengthsOf(solution);
    inverse_.pose = robot_.home;
  }

  // Refused with a sentence that contains the words, and nothing but finite numbers.
  static void expectRefused(const RobotSolution& solution, Code code, const std::string& words) {
    EXPECT_EQ(solution.report.status.code, code) << solution.report.status.message;
    EXPECT_NE(solution.report.status.message.find(words), std::string::npos) << solution.report.status.message;
    EXPECT_TRUE(isFinite(solution));
  }
  void expectForwardRefused(const std::function<void(ForwardRequest*)>& spoil, const std::string& words) const {
    ForwardRequest request = forward_;
    spoil(&request);
    for (const Model model : {Model::kStraight, Model::kStraightElastic, Model::kCatenary, Model::kBending}) {
      expectRefused(solveForward(robot_, request, patient(model)), Code::kInvalidInput, words);
    }
  }
  void expectInverseRefused(const std::function<void(InverseRequest*)>& spoil, const std::string& words) const {
    InverseRequest request = inverse_;
    spoil(&request);
    for (const Model model : {Model::kStraight, Model::kStraightElastic, Model::kCatenary, Model::kBending}) {
      expectRefused(solveInverse(robot_, request, patient(model)), Code::kInvalidInput, words);
    }
  }

  const RobotDescription robot_ = shippedRobot(ROBOT_DIR, "cogiro");
  const RobotSolverOptions options_ = patient(Model::kCatenary);
  ForwardRequest forward_;
  InverseRequest inverse_;
};

TEST_F(Refusals, LengthsAreCounted) {
  expectForwardRefused([](ForwardRequest* r) { r->lengths.pop_back(); },
                       "lengths has 7 entries: expected 8, one for each of cable0");
  expectForwardRefused([](ForwardRequest* r) { r->lengths.clear(); },
                       "lengths has 0 entries: expected 8, one for each of cable0");
}

TEST_F(Refusals, LengthsMustBePositiveAndFinite) {
  for (const double bad : {0.0, -1.0, kNan, kInfinity, 1e9}) {
    expectForwardRefused([&](ForwardRequest* r) { r->lengths[3] = bad; },
                         "lengths[3] of cable '" + robot_.cables[3].name + "' is");
  }
}

TEST_F(Refusals, WrenchesMustBeFinite) {
  for (const double bad : {kNan, kInfinity, 1e15}) {
    expectForwardRefused([&](ForwardRequest* r) { r->external_wrench(4) = bad; }, "external_wrench.torque.y is");
    expectInverseRefused([&](InverseRequest* r) { r->external_wrench(1) = bad; }, "external_wrench.force.y is");
  }
}

TEST_F(Refusals, PosesMustBeFiniteWithAUnitQuaternion) {
  for (const double bad : {kNan, kInfinity, 1e9}) {
    expectForwardRefused([&](ForwardRequest* r) { r->seed.emplace().position.x() = bad; }, "seed.position.x is");
    expectInverseRefused([&](InverseRequest* r) { r->pose.position.z() = bad; }, "pose.position.z is");
  }
  for (const Eigen::Vector4d& bad : {Eigen::Vector4d(0.0, 0.0, 0.0, 0.0), Eigen::Vector4d(0.0, 0.0, 0.0, 2.0),
                                     Eigen::Vector4d(kNan, 0.0, 0.0, 1.0)}) {
    expectForwardRefused([&](ForwardRequest* r) { r->seed.emplace().orientation.coeffs() = bad; }, "quaternion");
    expectInverseRefused([&](InverseRequest* r) { r->pose.orientation.coeffs() = bad; }, "quaternion");
  }
}

TEST_F(Refusals, PreferredTensionsAreCountedAndChecked) {
  expectInverseRefused([](InverseRequest* r) { r->preferred_tensions.assign(7, 100.0); },
                       "preferred_tensions has 7 entries: expected 8, one for each of cable0");
  for (const double bad : {-1.0, kNan, kInfinity}) {
    expectInverseRefused(
        [&](InverseRequest* r) {
          r->preferred_tensions.assign(8, 100.0);
          r->preferred_tensions[2] = bad;
        },
        "preferred_tensions[2] of cable '" + robot_.cables[2].name + "' is");
  }
}

TEST_F(Refusals, ModelsAndTolerancesThatCannotBeServed) {
  for (const Model model : {Model::kDefault, static_cast<Model>(9)}) {
    expectRefused(solveForward(robot_, forward_, patient(model)), Code::kInvalidInput, "model");
    expectRefused(solveInverse(robot_, inverse_, patient(model)), Code::kInvalidInput, "model");
  }
  for (const double bad : {0.0, -1.0, 1.0, kNan}) {
    expectRefused(solveForward(robot_, forward_, patient(Model::kBending, bad)), Code::kInvalidInput, "tolerance");
    expectRefused(solveInverse(robot_, inverse_, patient(Model::kBending, bad)), Code::kInvalidInput, "tolerance");
  }
}

TEST_F(Refusals, NoTimeIsTimedOut) {
  for (const Model model : {Model::kStraight, Model::kStraightElastic, Model::kCatenary, Model::kBending}) {
    SCOPED_TRACE(modelName(model));
    RobotSolverOptions options = patient(model);
    options.timeout = std::chrono::duration<double>(1e-9);
    expectRefused(solveForward(robot_, forward_, options), Code::kTimedOut, "time");
    expectRefused(solveInverse(robot_, inverse_, options), Code::kTimedOut, "time");
  }
}

TEST_F(Refusals, AMillisecondIsObeyedOrEnough) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "ipanema3");
  const RobotSolution at = solveInverse(robot, requestFor(robot, robot.home), patient(Model::kBending));
  ASSERT_TRUE(at.report.status.ok());
  ForwardRequest request;
  request.lengths = lengthsOf(at);
  Pose seed = robot.home;
  seed.position += Eigen::Vector3d(0.4, -0.3, 0.2);
  request.seed = seed;
  RobotSolverOptions options = patient(Model::kBending);
  options.timeout = std::chrono::duration<double>(1e-3);
  const RobotSolution forward = solveForward(robot, request, options);
  const RobotSolution inverse = solveInverse(robot, requestFor(robot, robot.home), options);
  for (const RobotSolution& solution : {forward, inverse}) {
    const Code code = solution.report.status.code;
    EXPECT_TRUE(code == Code::kTimedOut || code == Code::kConverged) << solution.report.status.message;
    EXPECT_LT(solution.report.solve_time, 0.2);
    EXPECT_TRUE(isFinite(solution));
  }
}

// What a solve did before it gave up is what a user needs to see.
TEST_F(Refusals, AFailureReportsItsIterationsAndResiduals) {
  InverseRequest heavy = inverse_;
  heavy.external_wrench.z() = -1e5;
  const RobotSolution inverse = solveInverse(robot_, heavy, options_);
  EXPECT_EQ(inverse.report.status.code, Code::kInfeasible);
  EXPECT_GT(inverse.report.iterations, 0);
  EXPECT_GT(inverse.report.force_residual, 0.0);

  ForwardRequest short_ones = forward_;
  for (double& length : short_ones.lengths) length *= 0.05;
  const RobotSolution forward = solveForward(robot_, short_ones, patient(Model::kCatenaryInextensible));
  EXPECT_FALSE(forward.report.status.ok());
  EXPECT_GT(forward.report.iterations, 0);
  EXPECT_GT(forward.report.closure_residual, 0.0);
  EXPECT_TRUE(isFinite(inverse) && isFinite(forward));
}

TEST_F(Refusals, APoseOutOfTheWorkspaceNamesCablesAndLimits) {
  for (const Model model : {Model::kCatenary, Model::kBending}) {
    InverseRequest request = inverse_;
    request.pose.position = Eigen::Vector3d(12.0, 0.0, 1.5);  // outside the frame
    const RobotSolution solution = solveInverse(robot_, request, patient(model));
    expectRefused(solution, Code::kInfeasible, "'cable");
    EXPECT_NE(solution.report.status.message.find("tension_"), std::string::npos) << solution.report.status.message;
  }
}

TEST_F(Refusals, ALoadBeyondTheLimitsIsInfeasible) {
  InverseRequest request = inverse_;
  request.external_wrench.z() = -1e5;
  expectRefused(solveInverse(robot_, request, options_), Code::kInfeasible, "tension_max");
  request.external_wrench.z() = 2.0 * robot_.weight();  // no cable pulls down
  expectRefused(solveInverse(robot_, request, options_), Code::kInfeasible, "'cable");
}

TEST_F(Refusals, APointMassOnTwoCablesStaysInTheirPlane) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "paper_point_mass");
  for (const Model model : {Model::kStraightElastic, Model::kCatenary, Model::kBending}) {
    InverseRequest request = requestFor(robot, robot.home);
    EXPECT_TRUE(solveInverse(robot, request, patient(model)).report.status.ok());
    request.pose.position.y() = 0.1;
    expectRefused(solveInverse(robot, request, patient(model)), Code::kInfeasible, "cannot balance");
  }
}

TEST_F(Refusals, APointMassTakesNoTorque) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "paper_point_mass");
  InverseRequest request = requestFor(robot, robot.home);
  request.external_wrench(5) = 1.0;
  expectRefused(solveInverse(robot, request, options_), Code::kInvalidInput, "external_wrench.torque is (0, 0, 1)");
}

TEST_F(Refusals, FewCablesNeedAFreeAttitude) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "scampi");
  InverseRequest request = requestFor(robot, robot.home);
  request.free_orientation = false;
  request.pose.orientation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
  expectRefused(solveInverse(robot, request, options_), Code::kInfeasible, "free_orientation");
}

TEST_F(Refusals, RobotsBuiltInCodeAreCheckedLikeFiles) {
  RobotDescription robot = robot_;
  robot.cables[1].attachment.x() = kNan;
  expectRefused(solveForward(robot, forward_, options_), Code::kInvalidInput, "attachment");
  expectRefused(solveInverse(robot, inverse_, options_), Code::kInvalidInput, "attachment");
}

// There is no direction to pull in.
TEST_F(Refusals, AnAttachmentOnItsAnchorIsNoAnswerWithoutNumbers) {
  for (const Model model : {Model::kStraight, Model::kStraightElastic, Model::kCatenaryInextensible, Model::kCatenary,
                            Model::kCatenaryCorrected, Model::kBendingInextensible, Model::kBending, Model::kAuto}) {
    SCOPED_TRACE(modelName(model));
    InverseRequest request = inverse_;
    request.pose.position = robot_.cables[0].anchor - request.pose.orientation * robot_.cables[0].attachment;
    RobotSolverOptions options = patient(model);
    options.timeout = std::chrono::duration<double>(1.0);
    const RobotSolution inverse = solveInverse(robot_, request, options);
    EXPECT_FALSE(inverse.report.status.ok());
    EXPECT_FALSE(inverse.report.status.message.empty());
    EXPECT_TRUE(isFinite(inverse));
    ForwardRequest from_there = forward_;
    from_there.seed = request.pose;
    const RobotSolution forward = solveForward(robot_, from_there, options);
    EXPECT_TRUE(isFinite(forward));
    if (forward.report.status.ok()) {
      EXPECT_LT(forward.report.force_residual, 1e-4 * robot_.weight());
    }
  }
}

TEST_F(Refusals, AbsurdLengthsEndInAStatus) {
  for (const double factor : {1e-6, 0.05, 0.5, 3.0, 100.0}) {
    for (const Model model : {Model::kStraight, Model::kStraightElastic, Model::kCatenaryInextensible, Model::kCatenary,
                              Model::kBendingInextensible, Model::kBending}) {
      ForwardRequest request = forward_;
      for (double& length : request.lengths) length *= factor;
      RobotSolverOptions options = patient(model);
      options.timeout = std::chrono::duration<double>(1.0);
      const RobotSolution solution = solveForward(robot_, request, options);
      EXPECT_NE(solution.report.status.code, Code::kUnset);
      EXPECT_NE(solution.report.status.code, Code::kInternalError);
      EXPECT_TRUE(isFinite(solution)) << modelName(model) << ", lengths times " << factor;
      EXPECT_LT(solution.report.solve_time, 1.5) << modelName(model) << ", lengths times " << factor;
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics
