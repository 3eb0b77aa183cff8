// The paper's section 4, a point mass on two bars of 4 to 5 m and 7 m: positions to 1e-9 m.
//
// The values are those of an independent solver, scripts/studies/section4_collocation.py (Chebyshev collocation of both
// cables at once, 73 nodes; closed forms for the other models). docs/section4.md has the whole table.
#include <gtest/gtest.h>

#include <cmath>

#include "cdpr_kinetostatics/robot/forward.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kPositionTolerance = 1e-9;  // [m]
constexpr double kTensionTolerance = 1e-6;   // [N]

RobotDescription loadedWith(double load) {
  RobotDescription robot = shippedRobot(ROBOT_DIR, "paper_point_mass");
  robot.mass = load / robot.gravity;
  return robot;
}

RobotSolution solve(double load, double first_length, Model model, const Pose& seed) {
  ForwardRequest request;
  request.lengths = {first_length, 7.0};
  request.seed = seed;
  return solveForward(loadedWith(load), request, patient(model));
}

struct Point {
  double load, first_length;
  Model model;
  double x, z;
};

class Section4 : public testing::TestWithParam<Point> {};

// The second seed is the mirror image above the line of the anchors, near equilibria of pushing bars that are unstable.
TEST_P(Section4, TheMassHangsWhereTheIndependentSolverHasIt) {
  const Point& point = GetParam();
  for (const Eigen::Vector3d& seed : {Eigen::Vector3d(3.8, 0.0, -1.253), Eigen::Vector3d(3.05, 0.0, 2.45)}) {
    Pose pose;
    pose.position = seed;
    const RobotSolution solution = solve(point.load, point.first_length, point.model, pose);
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    EXPECT_NEAR(solution.pose.position.x(), point.x, kPositionTolerance);
    EXPECT_NEAR(solution.pose.position.y(), 0.0, kPositionTolerance);
    EXPECT_NEAR(solution.pose.position.z(), point.z, kPositionTolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Table, Section4,
                         testing::Values(Point{500, 4, Model::kStraight, 3.799875601873, -1.249378009366},
                                         Point{500, 4, Model::kCatenary, 3.802498468759, -1.233858992337},
                                         Point{500, 4, Model::kBendingInextensible, 3.801896613119, -1.241399398129},
                                         Point{500, 4, Model::kBending, 3.801887033371, -1.241618433332},
                                         Point{500, 4.5, Model::kBendingInextensible, 4.125403020605, -1.794630814866},
                                         Point{500, 4.5, Model::kBending, 4.125394301231, -1.794787406605},
                                         Point{500, 5, Model::kStraight, 4.454284165417, -2.271420827085},
                                         Point{500, 5, Model::kCatenary, 4.455730217856, -2.251301235482},
                                         Point{500, 5, Model::kBendingInextensible, 4.456182225364, -2.263078231110},
                                         Point{500, 5, Model::kBending, 4.456176150614, -2.263207648676},
                                         Point{10000, 4, Model::kStraight, 3.799875601873, -1.249378009366},
                                         Point{10000, 4, Model::kCatenary, 3.799726490533, -1.252792483185},
                                         Point{10000, 4, Model::kBendingInextensible, 3.799886220715, -1.249319274817},
                                         Point{10000, 4, Model::kBending, 3.799726547929, -1.252796168558},
                                         Point{10000, 4.5, Model::kBendingInextensible, 4.123082992108,
                                               -1.802786234520},
                                         Point{10000, 4.5, Model::kBending, 4.122941757168, -1.805253328321},
                                         Point{10000, 5, Model::kBendingInextensible, 4.454291135661, -2.271344652383},
                                         Point{10000, 5, Model::kBending, 4.454194276205, -2.273367000709}),
                         [](const testing::TestParamInfo<Point>& each) {
                           return std::string(modelName(each.param.model)) + "_" +
                                  std::to_string(std::lround(each.param.load)) + "_N_" +
                                  std::to_string(std::lround(1e3 * each.param.first_length)) + "_mm";
                         });

struct Tensions {
  double load, first, second;
};

TEST(Section4Tensions, AgreeWithTheIndependentSolver) {
  for (const Tensions& expected :
       {Tensions{500, 803.4453401587646, 887.965659234818}, Tensions{10000, 12508.581158466022, 13438.92491355047}}) {
    const RobotDescription robot = loadedWith(expected.load);
    const RobotSolution solution = solve(expected.load, 4.0, Model::kBending, robot.home);
    ASSERT_TRUE(solution.report.status.ok()) << solution.report.status.message;
    EXPECT_NEAR(solution.cables[0].cable.tension_a, expected.first, kTensionTolerance);
    EXPECT_NEAR(solution.cables[1].cable.tension_a, expected.second, kTensionTolerance);
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics
