// Guide pulley and dead length in ~solve_cable: what is asked for reaches the core, named cables bring their own.
#include "ros/cable_service.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

namespace cdpr_kinetostatics {
namespace {

class CableService : public testing::Test {
 protected:
  CableService() {
    parameters_.robot = loadRobotFile(ROBOT_DIR "/cogiro.yaml").robot;
    parameters_.timeout = 10.0;
    request_.problem = SolveCable::Request::FIND_FORCES;
    request_.length = 8.94;
    request_.x = 8.0;
    request_.y = -4.0;
    request_.axial_stiffness = 2.87e5;
    request_.bending_stiffness = 0.16;
    request_.linear_density = 0.064;
    request_.pulley_radius = 0.05;
    request_.rope_from = "above";
    request_.dead_length = 12.0;
    request_.options.model = SolverOptions::BENDING;
  }

  std::string refusal() const {
    const SolveCable::Response response = serveCable(parameters_, request_);
    EXPECT_EQ(response.report.code, SolveReport::INVALID_INPUT);
    return response.report.message;
  }

  NodeParameters parameters_;
  SolveCable::Request request_;
};

TEST_F(CableService, PulleyAndDeadLengthAreTheCores) {
  const SolveCable::Response response = serveCable(parameters_, request_);
  ASSERT_EQ(response.report.code, SolveReport::CONVERGED) << response.report.message;
  CableProperties cable;
  cable.axial_stiffness = request_.axial_stiffness;
  cable.bending_stiffness = request_.bending_stiffness;
  cable.weight = request_.linear_density * parameters_.robot.gravity;
  cable.pulley = {request_.pulley_radius, RopeFrom::kAbove};
  cable.dead_length = request_.dead_length;
  CableSolverOptions options;
  options.model = Model::kBending;
  const CableSolution core = findForces(cable, request_.length, request_.x, request_.y, options);
  EXPECT_EQ(response.cable.tension_a, core.tension_a);
  EXPECT_EQ(response.cable.wrap_angle, core.wrap_angle);
  EXPECT_EQ(response.cable.departure.x, core.departure_x);
  EXPECT_EQ(response.cable.departure.z, core.departure_y);
  EXPECT_EQ(response.cable.force_on_platform.z, core.vertical_force_b);
  // Where the rope leaves is a point of the circle, and the curvature there is the circle's.
  EXPECT_NEAR(std::hypot(response.cable.departure.x - 0.05, response.cable.departure.z), 0.05, 1e-12);
  EXPECT_GE(response.cable.max_moment, 0.16 / 0.05 * (1.0 - 1e-9));
}

TEST_F(CableService, NamedCablesBringTheirOwn) {
  parameters_.robot.cables[3].properties.pulley = {0.06, RopeFrom::kBelow};
  request_.cable_name = parameters_.robot.cables[3].name;
  request_.options.model = SolverOptions::CATENARY;
  const SolveCable::Response response = serveCable(parameters_, request_);
  ASSERT_EQ(response.report.code, SolveReport::CONVERGED) << response.report.message;
  EXPECT_NEAR(std::hypot(response.cable.departure.x - 0.06, response.cable.departure.z), 0.06, 1e-12);
  EXPECT_GT(response.cable.departure.z, 0.0) << "over the top";
}

TEST_F(CableService, WithoutARadiusTheDepartureIsA) {
  request_.pulley_radius = 0.0;
  request_.rope_from.clear();
  const SolveCable::Response response = serveCable(parameters_, request_);
  ASSERT_EQ(response.report.code, SolveReport::CONVERGED) << response.report.message;
  EXPECT_EQ(response.cable.wrap_angle, 0.0);
  EXPECT_EQ(response.cable.departure.x, 0.0);
}

TEST_F(CableService, WhatCannotBeIsRefused) {
  request_.rope_from = "left";
  EXPECT_NE(refusal().find("rope_from is 'left': expected below or nothing, or above"), std::string::npos);
  request_.rope_from = "below";
  request_.pulley_radius = -0.05;
  EXPECT_NE(refusal().find("pulley_radius is -0.05"), std::string::npos);
  request_.pulley_radius = 0.05;
  request_.dead_length = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal().find("dead_length is"), std::string::npos);
  request_.dead_length = 1e9;
  EXPECT_NE(refusal().find("dead_length is"), std::string::npos);
}

TEST_F(CableService, AnEndWithinThePulleyIsInfeasible) {
  request_.x = 0.06;
  request_.y = 0.01;
  const SolveCable::Response response = serveCable(parameters_, request_);
  EXPECT_EQ(response.report.code, SolveReport::INFEASIBLE);
  EXPECT_NE(response.report.message.find("pulley"), std::string::npos) << response.report.message;
}

}  // namespace
}  // namespace cdpr_kinetostatics
