// Robots, poses and seeds that the tests of the robot layer share: the same every time, on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

// Random numbers without library distributions, which differ between implementations.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : generator_(seed) {}

  double uniform(double low, double high);
  // Mean 0, standard deviation 1.
  double normal();
  Eigen::Vector3d inBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
  // Uniform on the unit sphere.
  Eigen::Vector3d direction();
  Eigen::Quaterniond attitude();
  // Moved by exactly `distance` [m] and turned by exactly `angle` [rad], each in a random direction.
  Pose away(const Pose& pose, double distance, double angle);

 private:
  std::mt19937 generator_;
};

// Where a shipped robot's feasible poses are frequent.
struct Workspace {
  std::string robot;  // file name in config/robots, without .yaml
  Eigen::Vector3d low, high;
  double tilt = 0.0;  // largest rotation from level [rad]
};
std::vector<Workspace> shippedWorkspaces();
Workspace workspaceOf(const std::string& robot);
Pose randomPose(const Workspace& workspace, Dice* dice);

RobotDescription shippedRobot(const std::string& robot_directory, const std::string& name);

// Time enough for a busy machine; deadlines have tests of their own.
RobotSolverOptions patient(Model model, double tolerance = 1e-8);

// The pose as a request; fewer cables than freedoms of a rigid body leave the attitude to equilibrium.
InverseRequest requestFor(const RobotDescription& robot, const Pose& pose);

RobotSolution forward(const RobotDescription& robot, const std::vector<double>& lengths, const Pose& seed,
                      const RobotSolverOptions& options);

// Position and rotation within tolerance [m], [rad].
bool samePose(const Pose& a, const Pose& b, double tolerance);

// No answer and no refusal holds a NaN or an infinity.
bool isFinite(const RobotSolution& solution);

}  // namespace cdpr_kinetostatics
