#include "ros/diagnostics.h"

#include "cable/text.h"
#include "estimation/fault_names.h"
#include "ros/clock_watch.h"

namespace cdpr_kinetostatics {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

namespace {

// Empty if measurements agree within their deviations.
std::string disagreementOf(const DeviationFactors& factors) {
  std::string all;
  const auto add = [&](const char* what, const char* parameter, double factor) {
    if (factor > 1.0) all += text(all.empty() ? "" : ", ", what, " ", factor, " times as far as ", parameter, " says");
  };
  add("lengths", "~length_stddev", factors.lengths);
  add("tensions", "~tension_stddev", factors.tensions);
  add("the load", "~load_stddev", factors.load);
  return all.empty() ? "" : "measurements disagree: " + all + "; the covariance is widened";
}

}  // namespace

Diagnostics::Diagnostics(const ros::NodeHandle& private_handle, EstimatorLoop& loop, const NodeParameters& parameters)
    : loop_(loop),
      is_point_mass_(parameters.robot.type == PlatformType::kPointMass),
      max_age_(parameters.max_age),
      last_time_(ros::WallTime::now()),
      updater_(ros::NodeHandle(), private_handle) {
  updater_.setHardwareID(parameters.robot.name);
  updater_.add("input", this, &Diagnostics::input);
  updater_.add("solver", this, &Diagnostics::solver);
  updater_.add("estimate", this, &Diagnostics::estimate);
  const double period = private_handle.param("diagnostic_period", 1.0);
  timer_ = private_handle.createWallTimer(ros::WallDuration(period), [this, period](const ros::WallTimerEvent&) {
    // The updater adds its period to the time, and throws at the end of ROS' time.
    if (ros::Time::now().toSec() + period < ros::TIME_MAX.toSec()) updater_.force_update();
  });
}

void Diagnostics::input(DiagnosticStatusWrapper& status) {
  const EstimatorLoop::InputStatus now = loop_.inputStatus();
  const InputCounts& counts = now.counts;
  const std::string publishers = text("publishers on that topic: ", now.publishers);
  const double silence = ros::WallTime::now().toSec() - now.last_arrival.toSec();
  const std::uint64_t refused = counts.refused() - last_counts_.refused();
  const std::uint64_t incomplete = counts.missing_lengths + counts.missing_tensions + counts.unknown_names -
                                   last_counts_.missing_lengths - last_counts_.missing_tensions -
                                   last_counts_.unknown_names;
  const std::uint64_t impossible = counts.impossible - last_counts_.impossible;
  if (isTimeMissing()) {
    status.summary(DiagnosticStatus::ERROR, kNoTime);
  } else if (now.last_arrival.isZero()) {
    status.summary(DiagnosticStatus::WARN, text("waiting for ", now.topic, ": nothing received; ", publishers));
  } else if (silence > std::max(max_age_, 1.0)) {
    status.summary(DiagnosticStatus::ERROR, text("nothing on ", now.topic, " for ", silence, " s; ", publishers));
  } else if (counts.accepted == last_counts_.accepted && refused > 0) {
    status.summary(DiagnosticStatus::ERROR, text("every message is refused: ", now.last_problem));
  } else if (refused > 0) {
    status.summary(DiagnosticStatus::WARN, text(refused, " messages refused; the last: ", now.last_problem));
  } else if (counts.time_jumps > last_counts_.time_jumps) {
    status.summary(DiagnosticStatus::WARN, "time went backwards; the estimator started anew");
  } else if (impossible > 0) {
    status.summary(DiagnosticStatus::WARN, text("measurements that cannot be are left out: ", now.last_problem));
  } else if (incomplete > 0) {
    status.summary(DiagnosticStatus::WARN, text("measurements are missing: ", now.last_problem));
  } else if (now.superseded > last_superseded_) {
    status.summary(DiagnosticStatus::WARN, text("measurements come faster than they are estimated: ",
                                                now.superseded - last_superseded_, " gave way to newer ones"));
  } else {
    status.summary(DiagnosticStatus::OK, "measurements arrive");
  }
  const ros::WallTime time = ros::WallTime::now();
  const double period = (time - last_time_).toSec();
  status.add("topic", now.topic);
  status.add("publishers", now.publishers);
  status.add("rate [Hz]", static_cast<double>(counts.received - last_counts_.received) / period);
  status.add("received", counts.received);
  status.add("accepted", counts.accepted);
  status.add("gave way to newer ones", now.superseded);
  status.add("refused: malformed", counts.malformed);
  status.add("refused: stale", counts.stale);
  status.add("refused: repeated stamp", counts.repeated);
  status.add("refused: out of order", counts.reordered);
  status.add("time went backwards", counts.time_jumps);
  status.add("unknown names", counts.unknown_names);
  status.add("missing lengths", counts.missing_lengths);
  status.add("missing tensions", counts.missing_tensions);
  status.add("impossible values", counts.impossible);
  status.add("last problem", now.last_problem);
  last_counts_ = counts;
  last_superseded_ = now.superseded;
  last_time_ = time;
}

void Diagnostics::solver(DiagnosticStatusWrapper& status) {
  estimator_status_ = loop_.takeEstimatorStatus();
  const EstimatorStatus& now = estimator_status_;
  if (now.solves == 0) {
    status.summary(DiagnosticStatus::OK, "no measurement yet");
  } else if (now.recent_failures > 0) {
    const bool all = now.recent_failures == now.recent_solves;
    status.summary(
        all ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN,
        text(now.recent_failures, " of ", now.recent_solves, " solves failed; the last: ", now.last_failure));
  } else {
    status.summary(DiagnosticStatus::OK, "solves converge");
  }
  status.add("solves", now.solves);
  status.add("failures", now.failures);
  status.add("cold starts", now.cold_starts);
  status.add("last code", now.last.code);
  status.add("last iterations", now.last.iterations);
  status.add("mean solve time [ms]",
             now.recent_solves == 0 ? 0.0 : 1e3 * now.recent_solve_time / static_cast<double>(now.recent_solves));
  status.add("largest solve time [ms]", 1e3 * now.largest_solve_time);
}

void Diagnostics::estimate(DiagnosticStatusWrapper& status) {
  const EstimatorStatus& now = estimator_status_;
  const std::string outliers = joined(now.outliers);
  const std::string suspects = joined(now.suspects);
  const std::string disagreement = disagreementOf(now.deviation_factors);
  if (now.solves == now.failures) {
    status.summary(DiagnosticStatus::OK, "no estimate yet");
    return;
  }
  if (now.recent_failures > 0 && now.recent_failures == now.recent_solves) {
    status.summary(DiagnosticStatus::WARN, "no estimate now: " + now.last_failure);
  } else if (now.unobservable_directions > 0) {
    status.summary(DiagnosticStatus::WARN,
                   text("the measurements leave ", now.unobservable_directions, " directions of the pose unknown"));
  } else if (!outliers.empty()) {
    status.summary(DiagnosticStatus::WARN, "left out as faulty: " + outliers +
                                               (suspects.empty() ? "" : "; it may be instead: " + suspects) +
                                               (disagreement.empty() ? "" : "; " + disagreement));
  } else if (!disagreement.empty()) {
    status.summary(DiagnosticStatus::WARN, disagreement);
  } else if (is_point_mass_) {
    status.summary(DiagnosticStatus::OK, "measurements agree; a point mass has no attitude, its variance is unknown");
  } else {
    status.summary(DiagnosticStatus::OK, "measurements agree");
  }
  status.add("left out as faulty", outliers);
  status.add("may be at fault instead", suspects);
  status.add("lengths: disagreement over deviation", now.deviation_factors.lengths);
  status.add("tensions: disagreement over deviation", now.deviation_factors.tensions);
  status.add("load: disagreement over deviation", now.deviation_factors.load);
  status.add("unknown directions", now.unobservable_directions);
  status.add("position standard deviation [m]", now.position_stddev);
  if (!is_point_mass_) status.add("rotation standard deviation [rad]", now.rotation_stddev);
  status.add("force standard deviation [N]", now.force_stddev);
  if (!is_point_mass_) status.add("torque standard deviation [N m]", now.torque_stddev);
  status.add("unknown components of the load", now.unknown_load_components);
  status.add("redundant measurements", now.redundancy);
  status.add("sum of squared residuals [sigma^2]", now.weighted_squares);
}

}  // namespace cdpr_kinetostatics
