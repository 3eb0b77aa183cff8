#include "robot_golden.h"

#include <yaml-cpp/yaml.h>

namespace cdpr_kinetostatics {
namespace {

constexpr double kNoLimit = 1e5;  // [N]

Eigen::Vector3d vector(const YAML::Node& node) {
  const auto v = node.as<std::vector<double>>();
  return {v.at(0), v.at(1), v.at(2)};
}

GoldenRobot::Answer answer(const YAML::Node& node) {
  return {node["H"].as<std::vector<double>>(), node["V"].as<std::vector<double>>(), node["L"].as<std::vector<double>>(),
          node["TA"].as<std::vector<double>>()};
}

GoldenRobot read(const YAML::Node& node) {
  GoldenRobot golden;
  RobotDescription& robot = golden.robot;
  robot.name = node["name"].as<std::string>();
  robot.gravity = node["g"].as<double>();
  robot.type = node["dof"].as<int>() == 3 ? PlatformType::kPointMass : PlatformType::kRigidBody;
  robot.mass = node["mass"].as<double>();
  robot.com = vector(node["com"]);
  for (std::size_t i = 0; i < node["A"].size(); ++i) {
    CableDescription cable;
    cable.name = "cable" + std::to_string(i);
    cable.anchor = vector(node["A"][i]);
    cable.attachment = vector(node["b"][i]);
    cable.properties = {node["EA"].as<double>(), node["EI"].as<double>(), node["rho"].as<double>() * robot.gravity};
    cable.tension_max = kNoLimit;
    robot.cables.push_back(cable);
  }
  golden.pose.position = vector(node["position"]);
  const auto q = node["quaternion"].as<std::vector<double>>();
  golden.pose.orientation = Eigen::Quaterniond(q.at(3), q.at(0), q.at(1), q.at(2)).normalized();
  const auto wrench = node["ext"].as<std::vector<double>>();
  for (int k = 0; k < 6; ++k) golden.external_wrench(k) = wrench.at(static_cast<std::size_t>(k));
  golden.catenary = answer(node["catenary"]);
  golden.bending = answer(node["bending"]);
  robot.home = golden.pose;
  return golden;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const GoldenRobot& golden) { return out << golden.robot.name; }

std::vector<GoldenRobot> goldenRobots(const std::string& directory) {
  std::vector<GoldenRobot> result;
  for (const YAML::Node& node : YAML::LoadFile(directory + "/robots.json")) result.push_back(read(node));
  return result;
}

}  // namespace cdpr_kinetostatics
