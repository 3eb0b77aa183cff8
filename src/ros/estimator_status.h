// What the estimator did since the last diagnostics, and its last estimate in words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/KinetostaticState.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"

namespace cdpr_kinetostatics {

struct EstimatorStatus {
  // Since the start.
  std::uint64_t solves = 0;
  std::uint64_t failures = 0;
  std::uint64_t cold_starts = 0;
  // Since the last diagnostics.
  std::uint64_t recent_solves = 0;
  std::uint64_t recent_failures = 0;
  double recent_solve_time = 0.0;   // sum [s]
  double largest_solve_time = 0.0;  // [s]

  SolveReport last;          // of the last solve
  std::string last_failure;  // message of the last solve that failed
  // Of the last estimate.
  std::vector<std::string> outliers;  // "length of cable3", "known load, force x"
  std::vector<std::string> suspects;  // which may be at fault instead
  DeviationFactors deviation_factors;
  int unobservable_directions = 0;
  int redundancy = 0;
  double weighted_squares = 0.0;
  double position_stddev = 0.0;  // largest of x, y, z [m]
  double rotation_stddev = 0.0;  // largest of the rotations about x, y, z [rad]
  double force_stddev = 0.0;     // largest of those components of the load that are known [N]
  double torque_stddev = 0.0;    // the same of its torque [N m]
  int unknown_load_components = 0;

  void add(const Estimate& estimate, const KinetostaticState& state);
  // Sets what counts since the last diagnostics to zero.
  void startAnew();
};

}  // namespace cdpr_kinetostatics
