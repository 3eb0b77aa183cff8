// What RViz draws: cables coloured by tension with a legend, the platform, and what pulls at it.
#pragma once

#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "cdpr_kinetostatics/KinetostaticState.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// From blue at the lowest tension to red at the highest, by the logarithm; cables with measurements left out are
// magenta, cables that push are white. Without profiles cables are drawn as chords. An arrow is the force that the
// cables hold: weight and load.
visualization_msgs::MarkerArray cableMarkers(const RobotDescription& robot, const KinetostaticState& state);

// A box of the robot's size around the attachments, and its edges alone, for where the platform is in truth.
visualization_msgs::Marker platformMarker(const RobotDescription& robot, const std_msgs::Header& header,
                                          const geometry_msgs::Pose& pose);
visualization_msgs::Marker platformOutline(const RobotDescription& robot, const std_msgs::Header& header,
                                           const geometry_msgs::Pose& pose);

}  // namespace cdpr_kinetostatics
