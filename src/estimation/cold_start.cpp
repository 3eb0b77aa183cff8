#include "estimation/cold_start.h"

#include <cmath>

#include "cable/tautness.h"
#include "robot/basin_search.h"
#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
RobotForces coldStart(const MeasuredRobot& measured, const Pose& seed, int* iterations) {
  const RobotDescription& robot = measured.robot;
  RobotForces start;
  start.pose = seed;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], seed);
    lengths.push_back(measured.measurements.lengths[i].value_or(std::hypot(plane.x, plane.y)));
  }
  *iterations += roughStart(robot, Wrench::Zero(), lengths, measured.deadline, &start).iterations;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const std::optional<double>& tension = measured.measurements.tensions[i];
    const double weight = robot.cables[i].properties.weight * lengths[i];
    if (!tension || *tension <= 0.5 * weight) continue;  // as slack as its length makes it
    const CablePlane plane = cablePlane(robot.cables[i], start.pose);
    const double chord = std::hypot(plane.x, plane.y);
    if (lengths[i] > kSlackExcess * chord) continue;  // its forces follow from its length, better than from the tension
    start.forces[i] = {*tension * distanceBeside(plane.x, lengths[i]) / chord,
                       0.5 * weight - *tension * plane.y / chord};
  }
  return start;
}

}  // namespace cdpr_kinetostatics
