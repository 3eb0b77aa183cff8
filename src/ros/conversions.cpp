#include "ros/conversions.h"

#include <xmlrpcpp/XmlRpcValue.h>

#include <algorithm>
#include <stdexcept>

namespace cdpr_kinetostatics {

namespace {

// What a cable's state is without its place in the world.
CableState inOwnPlane(const CableSolution& solution) {
  CableState state;
  state.model = static_cast<std::uint8_t>(solution.model);
  state.length = solution.length;
  state.strained_length = solution.strained_length;
  state.wrap_angle = solution.wrap_angle;
  state.tension_a = solution.tension_a;
  state.tension_b = solution.tension_b;
  state.horizontal_force = solution.horizontal_force;
  state.vertical_force_a = solution.vertical_force_a;
  state.angle_a = solution.angle_a;
  state.angle_b = solution.angle_b;
  state.sag = solution.sag;
  state.max_moment = solution.max_moment;
  state.max_shear = solution.max_shear;
  state.estimated_error = solution.estimated_error;
  state.error_known = solution.error_known;
  return state;
}

std::uint8_t toMsg(Condition condition) {
  switch (condition) {
    case Condition::kSlack:
      return CableState::SLACK;
    case Condition::kCompressed:
      return CableState::COMPRESSED;
    case Condition::kTaut:
      break;
  }
  return CableState::TAUT;
}

// A number without a point would be a whole number, and 1e+20 would be text.
YAML::Node numberNode(double number) {
  std::string digits = YAML::Node(number).Scalar();
  if (digits.find('.') == std::string::npos) digits.insert(std::min(digits.find('e'), digits.size()), ".0");
  return YAML::Node(digits);
}

// As in quotes: the text 010 is no number.
YAML::Node textNode(const std::string& text) {
  YAML::Node node(text);
  node.SetTag("!");
  return node;
}

}  // namespace

YAML::Node toYaml(const XmlRpc::XmlRpcValue& value) {
  using XmlRpc::XmlRpcValue;
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<const bool&>(value));
    case XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<const int&>(value));
    case XmlRpcValue::TypeDouble:
      return numberNode(static_cast<const double&>(value));
    case XmlRpcValue::TypeString:
      return textNode(static_cast<const std::string&>(value));
    case XmlRpcValue::TypeArray: {
      YAML::Node sequence(YAML::NodeType::Sequence);
      for (int i = 0; i < value.size(); ++i) sequence.push_back(toYaml(value[i]));
      return sequence;
    }
    case XmlRpcValue::TypeStruct: {
      YAML::Node map(YAML::NodeType::Map);
      for (auto entry = value.begin(); entry != value.end(); ++entry) map[entry->first] = toYaml(entry->second);
      return map;
    }
    case XmlRpcValue::TypeDateTime:
    case XmlRpcValue::TypeBase64:
    case XmlRpcValue::TypeInvalid:
      break;
  }
  throw std::invalid_argument("a date or binary data: expected numbers, strings, lists and maps");
}

Pose fromMsg(const geometry_msgs::Pose& pose) {
  Pose converted;
  converted.position = {pose.position.x, pose.position.y, pose.position.z};
  const auto& q = pose.orientation;
  converted.orientation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
  return converted;
}

Wrench fromMsg(const geometry_msgs::Wrench& wrench) {
  Wrench converted;
  converted << wrench.force.x, wrench.force.y, wrench.force.z, wrench.torque.x, wrench.torque.y, wrench.torque.z;
  return converted;
}

geometry_msgs::Pose toMsg(const Pose& pose) {
  geometry_msgs::Pose converted;
  converted.position = toPoint(pose.position);
  converted.orientation.x = pose.orientation.x();
  converted.orientation.y = pose.orientation.y();
  converted.orientation.z = pose.orientation.z();
  converted.orientation.w = pose.orientation.w();
  return converted;
}

geometry_msgs::Point toPoint(const Eigen::Vector3d& point) {
  geometry_msgs::Point converted;
  converted.x = point.x();
  converted.y = point.y();
  converted.z = point.z();
  return converted;
}

geometry_msgs::Vector3 toVector3(const Eigen::Vector3d& vector) {
  geometry_msgs::Vector3 converted;
  converted.x = vector.x();
  converted.y = vector.y();
  converted.z = vector.z();
  return converted;
}

SolveReport toMsg(const Status& status) {
  SolveReport converted;
  converted.code = static_cast<std::int32_t>(status.code);
  converted.message = status.message;
  return converted;
}

SolveReport toMsg(const RobotReport& report) {
  SolveReport converted = toMsg(report.status);
  converted.model = static_cast<std::uint8_t>(report.model);
  converted.iterations = report.iterations;
  converted.solve_time = report.solve_time;
  converted.closure_residual = report.closure_residual;
  converted.force_residual = report.force_residual;
  converted.moment_residual = report.moment_residual;
  converted.estimated_error = report.estimated_error;
  converted.estimated_rotation_error = report.estimated_rotation_error;
  return converted;
}

CableState toMsg(const CableResult& result) {
  CableState state = inOwnPlane(result.cable);
  state.name = result.name;
  state.condition = toMsg(result.condition);
  state.force_on_platform = toVector3(result.force_on_platform);
  state.departure = toPoint(result.departure);
  state.profile.reserve(result.profile.size());
  for (const Eigen::Vector3d& point : result.profile) state.profile.push_back(toPoint(point));
  return state;
}

std::vector<CableState> toMsg(const std::vector<CableResult>& results) {
  std::vector<CableState> states;
  states.reserve(results.size());
  for (const CableResult& result : results) states.push_back(toMsg(result));
  return states;
}

CableState toMsg(const CableSolution& solution, const std::string& name, Condition condition) {
  CableState state = inOwnPlane(solution);
  state.name = name;
  state.condition = toMsg(condition);
  state.force_on_platform = toVector3({-solution.horizontal_force, 0.0, solution.vertical_force_b});
  state.departure = toPoint({solution.departure_x, 0.0, solution.departure_y});
  state.profile.reserve(solution.profile.size());
  for (const ProfilePoint& point : solution.profile) state.profile.push_back(toPoint({point.x, 0.0, point.y}));
  return state;
}

std::vector<double> toMsg(const Eigen::Matrix<double, 6, 6>& matrix) {
  std::vector<double> row_major;
  row_major.reserve(36);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) row_major.push_back(matrix(i, j));
  }
  return row_major;
}

}  // namespace cdpr_kinetostatics
