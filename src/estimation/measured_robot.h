// One message's measurements with all that their adjustment needs.
#pragma once

#include <chrono>
#include <vector>

#include "estimation/adjustment.h"

namespace cdpr_kinetostatics {

struct MeasuredRobot {
  const RobotDescription& robot;
  const EstimatorOptions& options;
  const CableMeasurements& measurements;
  const std::chrono::steady_clock::time_point deadline;
  const Selection available;  // all that was measured or is known
  std::vector<Model> rungs;   // of each cable
};

// An observation that is left out, and what it would bring if it were not, to first order.
struct LeftOut {
  Observation observation;
  double gain = 0.0;        // more sum of squares
  double redundancy = 0.0;  // and more redundant measurements, 0 or 1
};

// An adjustment and what took part in it.
struct Candidate {
  Adjusted adjusted;
  Selection selection;
  // Per cable: d(translation, rotation vector)/d(x, y), how the pose moves if the cable's end lay elsewhere in its
  // plane under the same forces [-, rad/m]; empty until estimate_error.h needs it.
  std::vector<Eigen::Matrix<double, 6, 2>> pose_by_end;
  std::vector<LeftOut> left_out;  // filled by rival_faults.h
};

inline Candidate adjust(const MeasuredRobot& measured, const RobotForces& start, const Selection& selection) {
  return {adjust(measured.robot, measured.options, measured.measurements, selection, measured.rungs, start,
                 measured.deadline),
          selection,
          {},
          {}};
}

}  // namespace cdpr_kinetostatics
