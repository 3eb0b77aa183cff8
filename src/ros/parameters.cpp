#include "cdpr_kinetostatics/ros/parameters.h"

#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "cdpr_kinetostatics/ros/conversions.h"
#include "cdpr_kinetostatics/ros/request_checks.h"
#include "cdpr_kinetostatics/ros/text.h"

namespace cdpr_kinetostatics {

namespace {

using XmlRpc::XmlRpcValue;

constexpr std::array<const char*, 4> kKnownKeys = {"robot", "model", "tolerance", "timeout"};

[[noreturn]] void refuse(const std::string& key, const XmlRpcValue& value, const std::string& expected) {
  std::ostringstream shown;
  if (value.getType() == XmlRpcValue::TypeString) {
    shown << "'" << static_cast<const std::string&>(value) << "'";
  } else {
    value.write(shown);
  }
  throw std::invalid_argument(text("parameter ~", key, " is ", shown.str(), ": expected ", expected));
}

// YAML 1.1 reads 1e-8, without a point, as a string: a string that is a number in full is taken as one.
std::optional<double> asNumber(const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeInt:
      return static_cast<const int&>(value);
    case XmlRpcValue::TypeDouble:
      return static_cast<const double&>(value);
    case XmlRpcValue::TypeString: {
      const std::string& word = static_cast<const std::string&>(value);
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (word.empty() || *end != '\0') return std::nullopt;
      return number;
    }
    default:
      return std::nullopt;
  }
}

double numberBetween(const std::string& key, const XmlRpcValue& value, double low, double high, const char* unit) {
  const std::optional<double> number = asNumber(value);
  if (!number || !(*number >= low && *number <= high)) {
    refuse(key, value, text("a number from ", low, " to ", high, unit));
  }
  return *number;
}

Model modelOf(const XmlRpcValue& value) {
  std::optional<Model> model;
  if (value.getType() == XmlRpcValue::TypeString) model = modelFromName(static_cast<const std::string&>(value));
  if (!model || *model == Model::kDefault) {
    refuse("model", value,
           "one of straight, straight_elastic, catenary_inextensible, catenary, bending_inextensible, bending");
  }
  if (const auto problem = unavailable(*model)) throw std::invalid_argument("parameter ~model: " + *problem);
  return *model;
}

LoadedRobot robotOf(const XmlRpcValue& value) {
  try {
    return parseRobot(toYaml(value));
  } catch (const std::invalid_argument& problem) {
    throw std::invalid_argument(text("parameter ~robot: ", problem.what()));
  }
}

}  // namespace

LoadedParameters loadParameters(const XmlRpcValue& private_parameters) {
  LoadedParameters loaded;
  NodeParameters& parameters = loaded.parameters;
  const bool any = private_parameters.getType() == XmlRpcValue::TypeStruct;
  const auto given = [&](const char* key) { return any && private_parameters.hasMember(key); };

  if (!given("robot")) {
    throw std::invalid_argument(
        "parameter ~robot is missing: expected a robot description; roslaunch cdpr_kinetostatics "
        "kinetostatics.launch robot:=cogiro loads config/robots/cogiro.yaml there, robot_file:=PATH one of your own");
  }
  LoadedRobot robot = robotOf(private_parameters["robot"]);
  parameters.robot = std::move(robot.robot);
  for (const std::string& warning : robot.warnings) loaded.warnings.push_back("parameter ~robot: " + warning);

  if (given("model")) parameters.model = modelOf(private_parameters["model"]);
  if (given("tolerance")) {
    parameters.tolerance =
        numberBetween("tolerance", private_parameters["tolerance"], kMinTolerance, kMaxTolerance, "");
  }
  if (given("timeout")) {
    parameters.timeout = numberBetween("timeout", private_parameters["timeout"], kMinTimeout, kMaxTimeout, " s");
  }

  for (auto entry = private_parameters.begin(); entry != private_parameters.end(); ++entry) {
    if (std::find(kKnownKeys.begin(), kKnownKeys.end(), entry->first) != kKnownKeys.end()) continue;
    std::string known;
    for (const char* key : kKnownKeys) known += text(known.empty() ? "~" : ", ~", key);
    loaded.warnings.push_back(
        text("parameter ~", entry->first, " is unknown and ignored: the node's parameters are ", known));
  }
  return loaded;
}

}  // namespace cdpr_kinetostatics
