// The third problem on the robot: from measured cable lengths and tensions to the platform's pose.
//
// Weighted least squares (docs/theory.md section 5). Unknown: the pose and, per cable, (H, V) and L, tied by
// closure, a constraint. Each measurement appears once, divided by its standard deviation: unstrained
// lengths, tensions at A, and, if the load is known, the six components of equilibrium. Tension is never
// turned into length, so a cable near the least tension that can hold it does no harm.
//
// Faulty measurements are found by data snooping: while a residual exceeds the threshold in units of its own
// standard deviation, that measurement (or load component) is left out without which the others agree best.
// docs/estimation.md says how well all this works.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/robot_description.h"
#include "cdpr_kinetostatics/robot/robot_solution.h"

namespace cdpr_kinetostatics {

struct EstimatorOptions {
  Model model = Model::kBending;
  double accuracy = 1e-4;   // AUTO: what the cables' rungs may neglect, at the estimated pose [m]
  double tolerance = 1e-8;  // relative, of the cables' integration
  std::chrono::duration<double> timeout{0.1};
  double length_stddev = 1e-3;  // [m]
  double tension_stddev = 5.0;  // [N]
  // The platform carries its weight and nothing else, to within load_stddev [N, N, N, N m, N m, N m].
  bool known_load = true;
  Wrench load_stddev = Wrench::Constant(1.0);
  double outlier_threshold = 6.0;  // [standard deviations of the residual]
  int profile_points = 0;          // of each cable; 0, or at least 2

  // 1 % of the platform's weight; of the weight times the platform's radius for torques.
  static Wrench defaultLoadStddev(const RobotDescription& robot);
  // False, with a sentence, if a value is out of range.
  bool isValid(std::string* error) const;
};

// What a message brings, in the robot's order; empty where a cable has no measurement.
struct CableMeasurements {
  std::vector<std::optional<double>> lengths;   // unstrained [m]
  std::vector<std::optional<double>> tensions;  // at A [N]
};

// Deviations of the measurements over those that the options say, 1 or more.
struct DeviationFactors {
  double lengths = 1.0, tensions = 1.0, load = 1.0;
};

struct Estimate {
  // Pose, cables and evidence; report.status tells whether there is an estimate at all.
  RobotSolution solution;
  bool warm_started = false;

  // Of (x, y, z, rotation about the world's x, y, z) [m^2, m rad, rad^2]; a direction that the data cannot
  // fix, and the rotations of a point mass, carry kUnknownVariance.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  int unobservable_directions = 0;

  Wrench load = Wrench::Zero();  // external load that balances the cables and the platform's weight
  // Of the load [N^2, N^2 m, N^2 m^2]. Components that the data cannot fix are unknown: their variance is that of a
  // load of kUnknownLoad times the weight. A point mass has no torques: 0.
  Eigen::Matrix<double, 6, 6> load_covariance = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Array<bool, 6, 1> load_unknown = Eigen::Array<bool, 6, 1>::Constant(false);

  // Measured minus model [m, N]; 0 where there is no measurement.
  std::vector<double> length_residual, tension_residual;
  // Measurements left out as faulty.
  std::vector<bool> length_outlier, tension_outlier;
  // Share of a measurement's error that shows in its own residual, 0 to 1: how well the others check it. A fault is
  // found from about outlier_threshold / sqrt(redundancy) standard deviations on.
  std::vector<double> length_redundancy, tension_redundancy;
  // Components of the known load that the measurements contradict.
  Eigen::Array<bool, 6, 1> load_outlier = Eigen::Array<bool, 6, 1>::Constant(false);
  // What may be at fault instead: measurements and components of the load, each of which, left out in the place of one
  // that was, leaves the others in agreement as well. The covariance covers the answers without these.
  std::vector<bool> length_suspect, tension_suspect;
  Eigen::Array<bool, 6, 1> load_suspect = Eigen::Array<bool, 6, 1>::Constant(false);
  // More than 1 where the last messages disagree beyond their deviations: the estimate uses deviations so much larger.
  DeviationFactors deviation_factors;

  double weighted_squares = 0.0;  // sum of squared residuals in units of their standard deviations
  int redundancy = 0;             // measurements in use minus unknowns
};

// Variance of what the data cannot fix, in the covariance's units: large beside any robot, small beside what a filter
// that reads the covariance can still invert.
constexpr double kUnknownVariance = 1e6;
// Standard deviation of a load that the data cannot fix, as a multiple of the platform's weight.
constexpr double kUnknownLoad = 1e3;

class PoseEstimator {
 public:
  // The robot must outlive the estimator.
  PoseEstimator(const RobotDescription& robot, const EstimatorOptions& options);
  PoseEstimator(PoseEstimator&& other) noexcept;
  ~PoseEstimator();

  // Starts from the last estimate if there is one. Unless that leads to a stable pose close by that explains all of the
  // measurements, a start from the seed competes, then one from the robot's home, then one from the last pose; the
  // best answer counts. It depends on the measurements since reset() alone.
  Estimate update(const CableMeasurements& measurements);

  // Forgets all; the seed is the robot's home, or the pose given.
  void reset();
  void setPose(const Pose& seed);

 private:
  class Tracker;
  std::unique_ptr<Tracker> tracker_;
};

}  // namespace cdpr_kinetostatics
