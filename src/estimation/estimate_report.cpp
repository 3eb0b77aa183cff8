#include "estimation/estimate_report.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "estimation/estimate_covariance.h"
#include "estimation/estimate_error.h"
#include "estimation/fault_names.h"
#include "estimation/fault_search.h"
#include "robot/platform_error.h"
#include "robot/platform_statics.h"
#include "robot/solution_assembly.h"

namespace cdpr_kinetostatics {
namespace {

void fillCables(const MeasuredRobot& measured, Candidate* candidate, Estimate* estimate) {
  const Adjusted& adjusted = candidate->adjusted;
  const RobotDescription& robot = measured.robot;
  assemble(robot, estimate->load,
           describeCables(robot, adjusted.unknowns.pose, adjusted.cables, measured.options.profile_points),
           &estimate->solution);
  reportEffect(measured, candidate, &estimate->solution);
}

// What a rival leaves out and the answer does not.
void fillSuspects(const MeasuredRobot& measured, const Selection& left_out, const std::vector<Candidate>& rivals,
                  Estimate* estimate) {
  estimate->length_suspect.assign(measured.robot.cables.size(), false);
  estimate->tension_suspect.assign(measured.robot.cables.size(), false);
  for (const Candidate& rival : rivals) {
    const Selection other = leftOut(measured, rival);
    for (std::size_t i = 0; i < measured.robot.cables.size(); ++i) {
      if (other.lengths[i] && !left_out.lengths[i]) estimate->length_suspect[i] = true;
      if (other.tensions[i] && !left_out.tensions[i]) estimate->tension_suspect[i] = true;
    }
    estimate->load_suspect = estimate->load_suspect || (other.load && !left_out.load);
  }
}

}  // namespace

Estimate report(const MeasuredRobot& measured, Candidate* candidate, const std::vector<Candidate>& rivals,
                const std::vector<Candidate>& unproven) {
  const RobotDescription& robot = measured.robot;
  Estimate estimate;
  const Adjusted& adjusted = candidate->adjusted;
  const RobotForces& at = adjusted.unknowns;
  estimate.solution.pose = at.pose;
  estimate.solution.report.status = adjusted.status;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const double tension = std::hypot(at.forces[i].horizontal, at.forces[i].vertical);
    estimate.length_residual.push_back(measured.available.lengths[i] ? *measured.measurements.lengths[i] - at.lengths[i]
                                                                     : 0.0);
    estimate.tension_residual.push_back(measured.available.tensions[i] ? *measured.measurements.tensions[i] - tension
                                                                       : 0.0);
  }
  estimate.load = balancingLoad(robot, adjusted);
  std::vector<Candidate> others = rivals;
  others.insert(others.end(), unproven.begin(), unproven.end());
  fillCovariances(robot, *candidate, others, &estimate);
  estimate.length_redundancy.assign(robot.cables.size(), 0.0);
  estimate.tension_redundancy.assign(robot.cables.size(), 0.0);
  for (const Observation& o : adjusted.observations) {
    if (o.kind == Observation::Kind::kLength) estimate.length_redundancy[o.index] = o.redundancy;
    if (o.kind == Observation::Kind::kTension) estimate.tension_redundancy[o.index] = o.redundancy;
  }
  const Selection left_out = leftOut(measured, *candidate);
  estimate.length_outlier = left_out.lengths;
  estimate.tension_outlier = left_out.tensions;
  estimate.load_outlier = left_out.load;
  fillSuspects(measured, left_out, rivals, &estimate);
  estimate.weighted_squares = adjusted.weighted_squares;
  estimate.redundancy = adjusted.redundancy;
  fillCables(measured, candidate, &estimate);
  std::string& message = estimate.solution.report.status.message;
  if (measured.options.model == Model::kAuto) message = describeChoice(estimate.solution);
  if (estimate.unobservable_directions > 0) {
    std::ostringstream text;
    text << "the measurements leave " << estimate.unobservable_directions
         << " direction(s) of the pose unknown; they carry a variance of " << kUnknownVariance;
    message = message.empty() ? text.str() : text.str() + "; " + message;
  }
  if (!rivals.empty()) {
    const std::string text =
        "which measurement is faulty cannot be told: " +
        joined(faultNames(estimate.solution, left_out.lengths, left_out.tensions, left_out.load)) +
        " left out, but it may be instead: " +
        joined(faultNames(estimate.solution, estimate.length_suspect, estimate.tension_suspect, estimate.load_suspect));
    message = message.empty() ? text : text + "; " + message;
  }
  return estimate;
}

}  // namespace cdpr_kinetostatics
