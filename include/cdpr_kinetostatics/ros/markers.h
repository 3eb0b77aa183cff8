// What RViz draws: cables coloured by tension with a legend, and the platform.
#pragma once

#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "cdpr_kinetostatics/KinetostaticState.h"
#include "cdpr_kinetostatics/robot/robot_description.h"

namespace cdpr_kinetostatics {

// From blue at the lowest tension to red at the highest, by the logarithm; cables with measurements left out are
// magenta, cables that push are white. Without profiles cables are drawn as chords.
visualization_msgs::MarkerArray cableMarkers(const RobotDescription& robot, const KinetostaticState& state);

// A box of the robot's size around the attachments.
visualization_msgs::Marker platformMarker(const RobotDescription& robot, const std_msgs::Header& header,
                                          const geometry_msgs::Pose& pose);

std_msgs::ColorRGBA rgba(double red, double green, double blue, double alpha);

}  // namespace cdpr_kinetostatics
