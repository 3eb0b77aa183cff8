#include "ros/parameters.h"

#include <filesystem>
#include <stdexcept>

#include "cable/input_limits.h"
#include "cable/text.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "robot/offsets_file.h"
#include "ros/conversions.h"
#include "ros/parameter_reader.h"

namespace cdpr_kinetostatics {

namespace {

// Finer accuracies are beneath the rounding of coordinates [m].
constexpr double kFinestAccuracy = 1e-15;

void readEstimator(ParameterReader& reader, NodeParameters* parameters) {
  EstimatorOptions& options = parameters->estimator;
  options.model = parameters->model;
  options.accuracy = parameters->accuracy;
  options.tolerance = parameters->tolerance;
  options.timeout = std::chrono::duration<double>(parameters->timeout);
  options.length_stddev = reader.number("length_stddev", options.length_stddev, 1e-9, 1e3, " m");
  options.tension_stddev = reader.number("tension_stddev", options.tension_stddev, 1e-6, 1e9, " N");
  options.known_load = reader.flag("known_load", options.known_load);
  options.load_stddev = EstimatorOptions::defaultLoadStddev(parameters->robot);
  const std::vector<double> load = reader.numbers("load_stddev", 6, 1e-9, kLargestForce, " [N, N, N, N m, N m, N m]");
  for (std::size_t i = 0; i < load.size(); ++i) options.load_stddev(static_cast<Eigen::Index>(i)) = load[i];
  options.outlier_threshold = reader.number("outlier_threshold", options.outlier_threshold, 1.0, 1e6, " sigma");
  options.profile_points = reader.integer("profile_points", 21, 0, kMostMessagePoints);
  if (options.profile_points == 1) reader.refuse("profile_points", "0 (no profiles) or at least 2");
  std::string problem;
  if (!options.isValid(&problem)) throw std::invalid_argument("parameters of the estimator: " + problem);
}

}  // namespace

RobotDescription readRobot(ParameterReader& reader, std::vector<std::string>* warnings) {
  if (!reader.has("robot")) {
    throw std::invalid_argument(
        "parameter ~robot is missing: expected a robot description; roslaunch cdpr_kinetostatics "
        "kinetostatics.launch robot:=cogiro loads config/robots/cogiro.yaml there, robot_file:=PATH one of your own");
  }
  try {
    LoadedRobot robot = parseRobot(toYaml(reader.value("robot")));
    for (const std::string& warning : robot.warnings) warnings->push_back("parameter ~robot: " + warning);
    return std::move(robot.robot);
  } catch (const std::invalid_argument& problem) {
    throw std::invalid_argument(text("parameter ~robot: ", problem.what()));
  }
}

Model readModel(ParameterReader& reader, Model fallback) {
  if (!reader.has("model")) return fallback;
  const XmlRpc::XmlRpcValue& value = reader.value("model");
  std::optional<Model> model;
  if (value.getType() == XmlRpc::XmlRpcValue::TypeString) {
    model = modelFromName(static_cast<const std::string&>(value));
  }
  if (!model || *model == Model::kDefault) {
    reader.refuse("model", modelNames());
  }
  return *model;
}

namespace {

// Until something is written there, the offsets are those of the robot's description.
void readOffsetsFile(ParameterReader& reader, NodeParameters* parameters) {
  if (!reader.has("offsets_file")) return;
  const std::string path = parameters->offsets_file = reader.word("offsets_file", "");
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  std::error_code unreadable;
  if (!std::filesystem::is_directory(folder, unreadable)) {
    reader.refuse("offsets_file", text("a file in a folder that exists, ", folder.string(), " does not"));
  }
  if (!std::filesystem::exists(path, unreadable)) return;
  RobotDescription& robot = parameters->robot;
  try {
    const std::vector<double> offsets = readOffsets(path, robot);
    for (std::size_t i = 0; i < offsets.size(); ++i) robot.cables[i].offset = offsets[i];
  } catch (const std::invalid_argument& problem) {
    throw std::invalid_argument(text("parameter ~offsets_file: ", problem.what()));
  }
}

}  // namespace

LoadedParameters loadParameters(const XmlRpc::XmlRpcValue& private_parameters) {
  LoadedParameters loaded;
  NodeParameters& parameters = loaded.parameters;
  ParameterReader reader(private_parameters);
  parameters.robot = readRobot(reader, &loaded.warnings);
  parameters.model = readModel(reader, parameters.model);
  parameters.accuracy = reader.number("accuracy", parameters.accuracy, kFinestAccuracy, kLargestLength, " m");
  parameters.tolerance = reader.number("tolerance", parameters.tolerance, kFinestTolerance, kCoarsestTolerance, "");
  parameters.timeout = reader.number("timeout", parameters.timeout, kShortestTimeout, kLongestTimeout, " s");

  readEstimator(reader, &parameters);
  readOffsetsFile(reader, &parameters);
  parameters.max_age = reader.number("max_age", parameters.max_age, 1e-3, 3600.0, " s");
  parameters.queue_size = reader.integer("queue_size", parameters.queue_size, 1, 100000);
  parameters.base_frame = reader.word("base_frame", parameters.base_frame);
  parameters.platform_frame = reader.word("platform_frame", parameters.platform_frame);
  if (parameters.platform_frame == parameters.base_frame) {
    reader.refuse("platform_frame", text("another frame than ~base_frame, which is '", parameters.base_frame, "'"));
  }
  parameters.publish_tf = reader.flag("publish_tf", parameters.publish_tf);
  parameters.marker_rate = reader.number("marker_rate", parameters.marker_rate, 0.0, 1000.0, " Hz");
  static_cast<void>(reader.number("diagnostic_period", 1.0, 0.01, 3600.0, " s"));  // diagnostic_updater reads it

  for (const std::string& warning : reader.ignored()) loaded.warnings.push_back(warning);
  return loaded;
}

}  // namespace cdpr_kinetostatics
