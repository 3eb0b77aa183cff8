#include <algorithm>
#include <cmath>
#include <sstream>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/estimation/pose_estimator.h"

namespace cdpr_kinetostatics {

Wrench EstimatorOptions::defaultLoadStddev(const RobotDescription& robot) {
  Wrench stddev;
  stddev << Eigen::Vector3d::Constant(0.01 * robot.weight()),
      Eigen::Vector3d::Constant(0.01 * robot.weight() * robot.lever());
  return stddev;
}

bool EstimatorOptions::isValid(std::string* error) const {
  std::ostringstream text;
  if (const Status model_status = checkModel(model); !model_status.ok()) {
    text << model_status.message;
  } else if (!(accuracy > 0.0 && std::isfinite(accuracy))) {
    text << "accuracy = " << accuracy << " m must be positive";
  } else if (!(length_stddev > 0.0 && std::isfinite(length_stddev))) {
    text << "length_stddev = " << length_stddev << " m must be positive";
  } else if (!(tension_stddev > 0.0 && std::isfinite(tension_stddev))) {
    text << "tension_stddev = " << tension_stddev << " N must be positive";
  } else if (!load_stddev.allFinite() || load_stddev.minCoeff() <= 0.0) {
    text << "load_stddev must be six positive numbers";
  } else if (!(outlier_threshold > 0.0)) {
    text << "outlier_threshold = " << outlier_threshold << " must be positive";
  }
  *error = text.str();
  return error->empty();
}

}  // namespace cdpr_kinetostatics
