// Runs the trials of a robot and sums them up: one row for each problem and setting.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tradeoff/trial.h"

namespace cdpr_kinetostatics {

struct Effort {
  std::vector<double> tolerances;  // of the rungs
  std::vector<double> accuracies;  // of AUTO [m]
  int poses = 0;
  double seconds_per_row = 0.0;  // timing stops then, or after samples_per_row, but not before each trial was timed
  int samples_per_row = 0;

  static Effort full();
  static Effort quick();
};

struct Row {
  Setting setting;
  Problem problem = Problem::kForwardCold;
  int trials = 0;
  int solved = 0;
  std::string refusal;  // code and sentence of the first trial that was not solved
  // Of those solved. Times in [s], of all repetitions; errors are the largest.
  double median_time = 0.0;
  double p99_time = 0.0;
  Errors errors;
  std::optional<double> estimated_error;  // the largest [m]
  Model finest = Model::kDefault;
  // Medians.
  double iterations = 0.0;
  double integrator_steps = 0.0;
  double evaluations = 0.0;
};

struct RobotTrade {
  RobotDescription robot;
  int poses = 0;
  // Least and largest kappa L = L sqrt(T_A/EI) over all poses and cables; none where no cable bends.
  std::optional<std::pair<double, double>> layers;
  std::vector<Row> rows;
};

RobotTrade measureTrade(const RobotDescription& robot, const Effort& effort);

}  // namespace cdpr_kinetostatics
