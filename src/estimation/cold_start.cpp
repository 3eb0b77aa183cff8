#include "estimation/cold_start.h"

#include "cable/tautness.h"
#include "robot/basin_search.h"
#include "robot/platform_statics.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
RobotForces coldStart(const MeasuredRobot& measured, const Pose& seed, int* iterations) {
  const RobotDescription& robot = measured.robot;
  RobotForces start;
  start.pose = seed;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], seed);
    const double straight = straightRope(robot.cables[i].properties, plane.x, plane.y).length();
    lengths.push_back(measured.measurements.lengths[i].value_or(straight));
  }
  *iterations += roughStart(robot, Wrench::Zero(), lengths, measured.deadline, &start).iterations;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const std::optional<double>& tension = measured.measurements.tensions[i];
    const CablePlane plane = cablePlane(robot.cables[i], start.pose);
    const StraightRope rope = straightRope(robot.cables[i].properties, plane.x, plane.y);
    const double weight = robot.cables[i].properties.weight * (lengths[i] - rope.wrapped);
    if (!tension || *tension <= 0.5 * weight) continue;  // as slack as its length makes it
    // The forces of a slack cable follow from its length, better than from the tension.
    if (lengths[i] > kSlackExcess * rope.length()) continue;
    start.forces[i] = {*tension * distanceBeside(rope.free.x(), lengths[i]) / rope.chord(),
                       0.5 * weight - *tension * rope.free.y() / rope.chord()};
  }
  return start;
}

}  // namespace cdpr_kinetostatics
