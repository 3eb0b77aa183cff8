#include "cable/cable_checks.h"
#include "cable/text.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"

namespace cdpr_kinetostatics {

Wrench EstimatorOptions::defaultLoadStddev(const RobotDescription& robot) {
  Wrench stddev;
  stddev << Eigen::Vector3d::Constant(0.01 * robot.weight()),
      Eigen::Vector3d::Constant(0.01 * robot.weight() * robot.lever());
  return stddev;
}

bool EstimatorOptions::isValid(std::string* error) const {
  Status status =
      firstRefusal(checkModel(model), checkAccuracy("accuracy", accuracy), checkTolerance("tolerance", tolerance),
                   checkPositive("length_stddev", length_stddev, kLargestLength, "m"),
                   checkPositive("tension_stddev", tension_stddev, kLargestForce, "N"),
                   checkProfilePoints("profile_points", profile_points));
  for (Eigen::Index k = 0; status.ok() && k < 6; ++k) {
    status = checkPositive("load_stddev", load_stddev(k), kLargestForce, k < 3 ? "N" : "N m");
  }
  if (status.ok() && !(outlier_threshold > 0.0)) {
    status = refused("outlier_threshold", text(outlier_threshold), "a positive number");
  }
  *error = status.message;
  return status.ok();
}

}  // namespace cdpr_kinetostatics
