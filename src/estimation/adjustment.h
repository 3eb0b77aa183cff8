// One weighted least-squares adjustment of a robot's measurements, and its statistics.
//
// Used by PoseEstimator, which decides what to leave out.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <vector>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/cable/report.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "robot/robot_forces.h"

namespace cdpr_kinetostatics {

// Some of the measurements, and components of the known load.
struct Selection {
  std::vector<bool> lengths, tensions;  // per cable
  Eigen::Array<bool, 6, 1> load = Eigen::Array<bool, 6, 1>::Constant(false);
};

// A measurement in units of its standard deviation.
struct Observation {
  enum class Kind { kLength, kTension, kLoad } kind = Kind::kLength;
  std::size_t index = 0;    // cable, or component of the load
  double residual = 0.0;    // model minus measured
  double redundancy = 0.0;  // share of an error that shows in the residual, 0 to 1
  Eigen::Index row = 0;     // of the Jacobian
};

// The same measurement, or component of the load.
inline bool isSame(const Observation& a, const Observation& b) { return a.kind == b.kind && a.index == b.index; }

struct Adjusted {
  Status status;
  int iterations = 0;
  RobotForces unknowns;
  std::vector<SaggingCable> cables;       // with their shapes, at the unknowns
  std::vector<Observation> observations;  // those that took part
  double weighted_squares = 0.0;
  int redundancy = 0;
  // Information of (translation, rotation vector), everything else eliminated; freedoms x freedoms.
  Eigen::MatrixXd information;
  // Of the external load; freedoms x freedoms. Nothing fixes the components that are unknown.
  Eigen::MatrixXd load_covariance;
  Eigen::Array<bool, 6, 1> load_unknown = Eigen::Array<bool, 6, 1>::Constant(false);
  // The platform would return to this pose if it were moved, the lengths held: a real one does.
  bool stable = false;
  // Of the residuals, selected measurements and load, by (translation, rotation vector, H/x of each cable).
  Eigen::MatrixXd jacobian;
};

// rungs: of each cable.
Adjusted adjust(const RobotDescription& robot, const EstimatorOptions& options, const CableMeasurements& measurements,
                const Selection& selection, const std::vector<Model>& rungs, const RobotForces& start,
                std::chrono::steady_clock::time_point deadline);

// Residuals and Jacobian at the state given, without adjusting it: observations have no redundancies yet. After the
// deadline bending cables cannot be evaluated.
Adjusted evaluate(const RobotDescription& robot, const EstimatorOptions& options, const CableMeasurements& measurements,
                  const Selection& selection, const std::vector<Model>& rungs, const RobotForces& at,
                  std::chrono::steady_clock::time_point deadline);

}  // namespace cdpr_kinetostatics
