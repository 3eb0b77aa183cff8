#include "cdpr_kinetostatics/robot/robot_description_yaml.h"

#include <yaml-cpp/yaml.h>

#include <set>
#include <stdexcept>

#include "cable/input_limits.h"
#include "geometry/spatial.h"
#include "robot/cable_keys.h"
#include "robot/platform_statics.h"
#include "robot/robot_checks.h"
#include "robot/straight_rope.h"
#include "robot/winch_keys.h"
#include "robot/yaml_file.h"
#include "robot/yaml_map.h"
#include "robot/yaml_tree.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kLeastChord = 1e-6;  // [m], between anchor and attachment at home

// Keys of oKermorgant/cdpr files that only its Gazebo simulation needs.
const std::set<std::string> kSimulationRoot = {"frame", "sim_cables"};
const std::set<std::string> kSimulationJoints = {"passive"};
const std::set<std::string> kSimulationActuated = {"velocity", "damping", "max"};
const std::set<std::string> kSimulationPlatform = {"inertia", "color", "visual"};

class Warnings {
 public:
  void addSimulationOnly(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) simulation_only_ += (simulation_only_.empty() ? "" : ", ") + path;
  }
  void addUnread(const YamlMap& map) {
    for (const std::string& path : map.unread()) others.push_back(path + " is ignored: no such key");
  }
  std::vector<std::string> all() const {
    std::vector<std::string> result = others;
    if (!simulation_only_.empty()) {
      result.push_back(simulation_only_ + ": ignored, of use to a dynamic simulation only");
    }
    return result;
  }

  std::vector<std::string> others;

 private:
  std::string simulation_only_;
};

PlatformType platformType(YamlMap& platform) {
  const std::string type = platform.textOr("type", "rigid_body");
  if (type == "point_mass") return PlatformType::kPointMass;
  const bool is_drawing_shape = type == "box";  // oKermorgant/cdpr
  if (type != "rigid_body" && !is_drawing_shape) platform.fail("type", "rigid_body or point_mass");
  return PlatformType::kRigidBody;
}

void readPlatform(YamlMap platform, RobotDescription& robot, Warnings& warnings) {
  robot.type = platformType(platform);
  robot.mass = platform.number("mass", Range::kPositive, "kg");
  robot.com = platform.vectorOr("com", Range::kAny, "m", robot.com);
  if (robot.type == PlatformType::kPointMass && !robot.com.isZero(0.0)) {
    platform.fail("com", "[0, 0, 0] for a point_mass");
  }
  robot.size = platform.vectorOr("size", Range::kPositive, "m", robot.size);

  YamlMap home = platform.map("position");
  robot.home.position = home.vector("xyz", Range::kAny, "m");
  robot.home.orientation = fromRollPitchYaw(home.vectorOr("rpy", Range::kAny, "rad", Eigen::Vector3d::Zero()));

  warnings.addSimulationOnly(platform.present(kSimulationPlatform));
  warnings.addUnread(platform);
  warnings.addUnread(home);
}

// Tension limits as files of oKermorgant/cdpr give them: joints/actuated/{min, effort}.
CableKeys readJoints(YamlMap joints, Warnings& warnings) {
  CableKeys limits;
  if (joints.has("actuated")) {
    YamlMap actuated = joints.map("actuated");
    if (const auto min = actuated.optionalNumber("min", Range::kNonNegative, "N")) {
      limits["tension_min"] = GivenNumber{*min, actuated.pathOf("min")};
    }
    if (const auto effort = actuated.optionalNumber("effort", Range::kPositive, "N")) {
      limits["tension_max"] = GivenNumber{*effort, actuated.pathOf("effort")};
    }
    warnings.addSimulationOnly(actuated.present(kSimulationActuated));
    warnings.addUnread(actuated);
  }
  warnings.addSimulationOnly(joints.present(kSimulationJoints));
  warnings.addUnread(joints);
  return limits;
}

CableKeys readDefaults(YamlMap& root, Warnings& warnings) {
  CableKeys defaults;
  if (root.has("cable")) defaults = readCableKeys(root.map("cable"), warnings.others);
  if (root.has("joints")) {
    for (const auto& [key, limit] : readJoints(root.map("joints"), warnings)) {
      const auto same = defaults.find(key);
      if (same != defaults.end()) agree(same->second, limit);
      defaults.emplace(key, limit);
    }
  }
  return defaults;
}

// What holds for all cables.
struct Defaults {
  CableKeys cable;
  WinchKeys winch;
};

CableDescription readPoint(YamlMap point, const std::string& default_name, const Defaults& defaults,
                           const RobotDescription& robot, Warnings& warnings) {
  CableDescription cable;
  cable.name = point.textOr("name", default_name);
  cable.anchor = point.vector("frame", Range::kAny, "m");
  if (robot.type == PlatformType::kPointMass) {
    cable.attachment = point.vectorOr("platform", Range::kAny, "m", cable.attachment);
    if (!cable.attachment.isZero(0.0)) point.fail("platform", "[0, 0, 0] for a point_mass");
  } else {
    cable.attachment = point.vector("platform", Range::kAny, "m");
  }
  if (anchorToAttachment(cable, robot.home).norm() < kLeastChord) {
    point.fail("frame", "a point away from where platform.position puts this cable's platform point");
  }

  CableKeys keys;
  if (point.has("cable")) keys = readCableKeys(point.map("cable"), warnings.others);
  keys.insert(defaults.cable.begin(), defaults.cable.end());
  resolveCable(keys, point.pathOf("cable"), robot.gravity, cable);
  resolveWinch(readWinchKeys(point, warnings.others), defaults.winch, cable);
  warnings.addUnread(point);
  return cable;
}

LoadedRobot parse(const YAML::Node& node, const std::string& default_name) {
  Warnings warnings;
  LoadedRobot loaded;
  RobotDescription& robot = loaded.robot;

  YamlMap root(plainTree(node), "");
  robot.name = root.textOr("name", default_name);
  robot.gravity = root.optionalNumber("gravity", Range::kPositive, "m/s^2").value_or(robot.gravity);
  readPlatform(root.map("platform"), robot, warnings);

  const Defaults defaults{readDefaults(root, warnings), readWinchKeys(root, warnings.others)};
  std::set<std::string> names;
  std::vector<YamlMap> points = root.maps("points");
  if (points.size() > kMostCables) {
    throw std::invalid_argument("points has " + std::to_string(points.size()) + " cables: expected at most " +
                                std::to_string(kMostCables));
  }
  for (YamlMap& point : points) {
    const std::string default_cable_name = "cable" + std::to_string(robot.cables.size());
    robot.cables.push_back(readPoint(point, default_cable_name, defaults, robot, warnings));
    if (!names.insert(robot.cables.back().name).second) {
      throw std::invalid_argument(point.pathOf("name") + " = " + robot.cables.back().name +
                                  ": expected a name that no other cable has");
    }
  }
  Status status = checkRobot(robot);
  if (status.ok()) status = checkPulleys(robot, robot.home);
  if (!status.ok()) throw std::invalid_argument(status.message);
  warnings.addSimulationOnly(root.present(kSimulationRoot));
  warnings.addUnread(root);
  loaded.warnings = warnings.all();
  return loaded;
}

std::string fileStem(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.find_last_of('.'));
}

}  // namespace

LoadedRobot parseRobot(const YAML::Node& node) { return parse(node, "robot"); }

LoadedRobot loadRobotFile(const std::string& path) {
  try {
    return parse(loadYamlFile(path), fileStem(path));
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(path + ": expected YAML; " + error.what());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace cdpr_kinetostatics
