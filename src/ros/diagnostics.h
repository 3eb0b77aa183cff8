// What the node says on /diagnostics: whether measurements arrive, whether the solver converges, and how far the
// estimate can be trusted.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/timer.h>

#include "ros/estimator_loop.h"

namespace cdpr_kinetostatics {

class Diagnostics {
 public:
  // The loop must outlive the diagnostics.
  Diagnostics(const ros::NodeHandle& private_handle, EstimatorLoop& loop, const NodeParameters& parameters);

 private:
  void input(diagnostic_updater::DiagnosticStatusWrapper& status);
  void solver(diagnostic_updater::DiagnosticStatusWrapper& status);
  void estimate(diagnostic_updater::DiagnosticStatusWrapper& status);

  EstimatorLoop& loop_;
  const bool is_point_mass_;
  const double max_age_;  // [s]
  InputCounts last_counts_;
  std::uint64_t last_superseded_ = 0;
  ros::WallTime last_time_;
  EstimatorStatus estimator_status_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace cdpr_kinetostatics
