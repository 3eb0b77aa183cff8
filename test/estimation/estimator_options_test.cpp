// What an estimator's options may be, and its default deviations of the load.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "cdpr_kinetostatics/estimation/pose_estimator.h"
#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

TEST(EstimatorOptions, DefaultsAreValid) {
  std::string error = "none";
  EXPECT_TRUE(EstimatorOptions().isValid(&error));
  EXPECT_TRUE(error.empty()) << error;
}

TEST(EstimatorOptions, NameWhatIsOutOfRange) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  struct Field {
    const char* name;
    std::function<void(EstimatorOptions*, double)> set;
    bool infinite;  // allowed
  };
  const Field fields[] = {
      {"accuracy", [](EstimatorOptions* o, double value) { o->accuracy = value; }, false},
      {"length_stddev", [](EstimatorOptions* o, double value) { o->length_stddev = value; }, false},
      {"tension_stddev", [](EstimatorOptions* o, double value) { o->tension_stddev = value; }, false},
      {"load_stddev", [](EstimatorOptions* o, double value) { o->load_stddev(4) = value; }, false},
      {"outlier_threshold", [](EstimatorOptions* o, double value) { o->outlier_threshold = value; }, true},
  };
  for (const Field& field : fields) {
    for (const double value : {0.0, -1.0, kNan, kInfinity}) {
      EstimatorOptions options;
      field.set(&options, value);
      std::string error;
      if (field.infinite && std::isinf(value)) {
        EXPECT_TRUE(options.isValid(&error)) << error;
        continue;
      }
      EXPECT_FALSE(options.isValid(&error)) << field.name << " = " << value;
      EXPECT_NE(error.find(field.name), std::string::npos) << error;
    }
  }
  EstimatorOptions options;
  options.model = static_cast<Model>(99);
  std::string error;
  EXPECT_FALSE(options.isValid(&error));
  EXPECT_FALSE(error.empty());
}

TEST(EstimatorOptions, DefaultDeviationsOfTheLoadAreAHundredthOfTheWeight) {
  for (const char* name : {"cogiro", "paper_point_mass"}) {
    const RobotDescription robot = shippedRobot(ROBOT_DIR, name);
    const Wrench stddev = EstimatorOptions::defaultLoadStddev(robot);
    double radius = 0.0;
    for (const CableDescription& cable : robot.cables) radius = std::max(radius, cable.attachment.norm());
    for (int k = 0; k < 3; ++k) {
      EXPECT_DOUBLE_EQ(stddev(k), 0.01 * robot.mass * robot.gravity);
      if (radius > 0.0) {
        EXPECT_DOUBLE_EQ(stddev(3 + k), 0.01 * robot.mass * robot.gravity * radius);
      }
      EXPECT_GT(stddev(3 + k), 0.0);
    }
  }
}

}  // namespace
}  // namespace cdpr_kinetostatics
