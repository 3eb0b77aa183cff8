// The node's private parameters (config/node.yaml documents each).
#pragma once

#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace XmlRpc {
class XmlRpcValue;
}

namespace cdpr_kinetostatics {

class ParameterReader;

// Of one solve [s]: less than a cable's solve takes, and more than anyone waits for a service.
inline constexpr double kShortestTimeout = 1e-4;
inline constexpr double kLongestTimeout = 3600.0;

// Points of each cable's profile in a message: eight cables with so many fill two megabytes.
inline constexpr int kMostMessagePoints = 10000;

struct NodeParameters {
  RobotDescription robot;      // ~robot, no default
  Model model = Model::kAuto;  // ~model
  double accuracy = 1e-4;      // ~accuracy [m]
  double tolerance = 1e-8;     // ~tolerance, relative [-]
  double timeout = 0.1;        // ~timeout, of one solve [s]

  // ~length_stddev, ~tension_stddev, ~known_load, ~load_stddev, ~outlier_threshold, ~profile_points; the rest
  // is that of the services.
  EstimatorOptions estimator;
  std::string offsets_file;                 // ~offsets_file, empty: none; its offsets are in robot
  double max_age = 0.5;                     // ~max_age, of a measurement when it arrives [s]
  int queue_size = 10;                      // ~queue_size, measurements that may wait for the estimator
  std::string base_frame = "world";         // ~base_frame
  std::string platform_frame = "platform";  // ~platform_frame
  bool publish_tf = true;                   // ~publish_tf
  double marker_rate = 10.0;                // ~marker_rate [Hz], 0: no markers
};

struct LoadedParameters {
  NodeParameters parameters;
  std::vector<std::string> warnings;  // what was ignored, and why
};

// Reads the struct of all private parameters. Throws std::invalid_argument whose text names the key, its
// value and what was expected.
LoadedParameters loadParameters(const XmlRpc::XmlRpcValue& private_parameters);

// What the simulated rig reads in the same way. Warnings are added to those that are there.
RobotDescription readRobot(ParameterReader& reader, std::vector<std::string>* warnings);
Model readModel(ParameterReader& reader, Model fallback);

}  // namespace cdpr_kinetostatics
