#include "rig/parameters.h"

#include <algorithm>
#include <stdexcept>

#include "cable/input_limits.h"
#include "cable/text.h"
#include "geometry/spatial.h"
#include "ros/parameter_reader.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {

namespace {

constexpr double kLatest = 1e9;  // [s since the rig's start], thirty years: never

// One reader for each map of a list; `read` takes it and its index.
template <typename Read>
void forEach(ParameterReader& reader, const char* key, std::vector<std::string>* warnings, Read read) {
  if (!reader.has(key)) return;
  const XmlRpc::XmlRpcValue& list = reader.value(key);
  if (list.getType() != XmlRpc::XmlRpcValue::TypeArray) reader.refuse(key, "a list of maps");
  for (int i = 0; i < list.size(); ++i) {
    if (list[i].getType() != XmlRpc::XmlRpcValue::TypeStruct) reader.refuse(key, "a list of maps");
    ParameterReader entry(list[i], text("~", key, "[", i, "]/"));
    read(entry);
    for (const std::string& warning : entry.ignored()) warnings->push_back(warning);
  }
}

RigFault readFault(ParameterReader& entry, const RobotDescription& robot) {
  RigFault fault;
  const std::vector<std::string> kinds = {"stuck_tension", "tension_bias", "length_offset", "no_length", "no_tension"};
  const std::string kind = entry.oneOf("kind", "", kinds);
  fault.kind = static_cast<RigFault::Kind>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
  std::vector<std::string> names;
  for (const CableDescription& cable : robot.cables) names.push_back(cable.name);
  const std::string name = entry.oneOf("cable", "", names);
  fault.cable = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  fault.value = entry.number("value", 0.0, -kLargestForce, kLargestForce, " N or m");
  fault.start = entry.number("start", 0.0, 0.0, kLatest, " s");
  fault.end = entry.number("end", kLatest, fault.start, kLatest, " s");
  return fault;
}

RigSensors readSensors(ParameterReader& reader, const RobotDescription& robot, std::vector<std::string>* warnings) {
  RigSensors sensors;
  sensors.seed = reader.integer("seed", sensors.seed, 0, 2147483647);
  sensors.tensions = reader.flag("tensions", sensors.tensions);
  sensors.length_noise = reader.number("length_noise", 0.0, 0.0, 1e3, " m");
  sensors.tension_noise = reader.number("tension_noise", 0.0, 0.0, 1e9, " N");
  sensors.length_bias = reader.number("length_bias", 0.0, -1e3, 1e3, " m");
  sensors.offset_error = reader.number("offset_error", 0.0, 0.0, 1e3, " m");
  sensors.tension_bias = reader.number("tension_bias", 0.0, -1e9, 1e9, " N");
  sensors.length_resolution = reader.number("length_resolution", 0.0, 0.0, 1e3, " m");
  sensors.tension_resolution = reader.number("tension_resolution", 0.0, 0.0, 1e9, " N");
  sensors.dropout = reader.number("dropout", 0.0, 0.0, 1.0, "");
  forEach(reader, "faults", warnings,
          [&](ParameterReader& entry) { sensors.faults.push_back(readFault(entry, robot)); });
  return sensors;
}

Pose readWaypoint(ParameterReader& entry, const RobotDescription& robot) {
  const std::vector<double> xyz = entry.numbers("xyz", 3, -kLargestLength, kLargestLength, " m");
  if (xyz.empty()) entry.refuse("xyz", "three coordinates [m]");
  Pose pose = robot.home;
  pose.position = {xyz[0], xyz[1], xyz[2]};
  const std::vector<double> rpy = entry.numbers("rpy", 3, -10.0, 10.0, " rad");
  if (!rpy.empty()) pose.orientation = fromRollPitchYaw({rpy[0], rpy[1], rpy[2]});
  return pose;
}

RigPath readPath(ParameterReader& reader, const RobotDescription& robot, std::vector<std::string>* warnings) {
  RigPath path;
  const std::vector<std::string> kinds = {"circle", "figure_of_eight", "waypoints", "target"};
  const std::string kind = reader.oneOf("path", "circle", kinds);
  path.kind = static_cast<RigPath::Kind>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
  if (reader.has("path_radius")) path.radius = reader.number("path_radius", 0.0, 0.0, kLargestLength, " m");
  path.period = reader.number("path_period", path.period, 0.01, 1e6, " s");
  path.speed = reader.number("speed", 0.02 * robot.span(), 1e-6, kLargestLength, " m/s");
  forEach(reader, "waypoints", warnings,
          [&](ParameterReader& entry) { path.waypoints.push_back(readWaypoint(entry, robot)); });
  if (path.kind == RigPath::Kind::kWaypoints && path.waypoints.size() < 2) {
    reader.refuse("waypoints", "at least two maps {xyz: [x, y, z], rpy: [r, p, y]}, as ~path is waypoints");
  }
  return path;
}

RigLoad readLoad(ParameterReader& entry) {
  RigLoad load;
  load.time = entry.number("time", 0.0, 0.0, kLatest, " s");
  const std::vector<double> wrench = entry.numbers("wrench", 6, -kLargestForce, kLargestForce, " N, N m");
  if (wrench.empty()) entry.refuse("wrench", "six numbers [N, N, N, N m, N m, N m]");
  for (std::size_t k = 0; k < 6; ++k) load.wrench(static_cast<Eigen::Index>(k)) = wrench[k];
  return load;
}

}  // namespace

LoadedRigParameters loadRigParameters(const XmlRpc::XmlRpcValue& private_parameters) {
  LoadedRigParameters loaded;
  RigParameters& parameters = loaded.parameters;
  ParameterReader reader(private_parameters);
  parameters.robot = readRobot(reader, &loaded.warnings);
  parameters.model = readModel(reader, parameters.model);
  parameters.tolerance = reader.number("tolerance", parameters.tolerance, kFinestTolerance, kCoarsestTolerance, "");
  parameters.rate = reader.number("rate", parameters.rate, 0.01, 10000.0, " Hz");
  parameters.base_frame = reader.word("base_frame", parameters.base_frame);
  parameters.path = readPath(reader, parameters.robot, &loaded.warnings);
  parameters.sensors = readSensors(reader, parameters.robot, &loaded.warnings);
  forEach(reader, "loads", &loaded.warnings,
          [&](ParameterReader& entry) { parameters.loads.push_back(readLoad(entry)); });
  std::stable_sort(parameters.loads.begin(), parameters.loads.end(),
                   [](const RigLoad& a, const RigLoad& b) { return a.time < b.time; });
  parameters.load_noise = reader.number("load_noise", 0.0, 0.0, 1e3, " of the weight");
  for (const std::string& warning : reader.ignored()) loaded.warnings.push_back(warning);
  return loaded;
}

}  // namespace cdpr_kinetostatics
