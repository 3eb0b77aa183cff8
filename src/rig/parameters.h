// The simulated rig's private parameters (config/rig.yaml documents each).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace XmlRpc {
class XmlRpcValue;
}

namespace cdpr_kinetostatics {

// What goes wrong with one cable's sensors, from `start` to `end` [s since the rig's start].
struct RigFault {
  enum class Kind { kStuckTension, kTensionBias, kLengthOffset, kNoLength, kNoTension } kind = Kind::kStuckTension;
  std::size_t cable = 0;
  double value = 0.0;  // [N] or [m]
  double start = 0.0;
  double end = 1e9;
};

struct RigSensors {
  int seed = 1;
  bool tensions = true;             // false: lengths only
  double length_noise = 0.0;        // standard deviation [m]
  double tension_noise = 0.0;       // standard deviation [N]
  double length_bias = 0.0;         // of all cables [m]
  double offset_error = 0.0;        // standard deviation of each drum's unknown zero, drawn once [m]
  double tension_bias = 0.0;        // of all cables [N]
  double length_resolution = 0.0;   // [m], 0: none
  double tension_resolution = 0.0;  // [N], 0: none
  double dropout = 0.0;             // share of messages that never arrive
  std::vector<RigFault> faults;
};

struct RigPath {
  enum class Kind { kCircle, kFigureOfEight, kWaypoints, kTarget } kind = Kind::kCircle;
  std::optional<double> radius;  // [m]; empty: 5 % of the span, or less if the cables cannot hold that
  double period = 20.0;          // of a circle or figure [s]
  double speed = 0.0;            // along waypoints and to a target [m/s]
  std::vector<Pose> waypoints;   // world
};

// The load from `time` on.
struct RigLoad {
  double time = 0.0;  // [s since the rig's start]
  Wrench wrench = Wrench::Zero();
};

struct RigParameters {
  RobotDescription robot;
  Model model = Model::kBending;
  double tolerance = 1e-10;
  double rate = 50.0;  // [Hz]
  std::string base_frame = "world";
  RigPath path;
  RigSensors sensors;
  std::vector<RigLoad> loads;  // in the order of time
  double load_noise = 0.0;     // standard deviation of a drawn load [weight; weight times platform's radius]
};

struct LoadedRigParameters {
  RigParameters parameters;
  std::vector<std::string> warnings;
};

// Throws std::invalid_argument, as loadParameters.
LoadedRigParameters loadRigParameters(const XmlRpc::XmlRpcValue& private_parameters);

}  // namespace cdpr_kinetostatics
