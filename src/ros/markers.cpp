#include "cdpr_kinetostatics/ros/markers.h"

#include <algorithm>
#include <cmath>

#include "cdpr_kinetostatics/ros/conversions.h"

namespace cdpr_kinetostatics {

namespace {

using visualization_msgs::Marker;

constexpr double kLineWidth = 0.0016;  // in spans of the frame
constexpr double kTextHeight = 0.018;  // in spans of the frame
constexpr int kLegendEntries = 5;

struct TensionScale {
  double low, high;  // [N]

  explicit TensionScale(const RobotDescription& robot) : low(robot.cables[0].tension_max), high(0.0) {
    for (const CableDescription& cable : robot.cables) {
      low = std::min(low, cable.tension_min);
      high = std::max(high, cable.tension_max);
    }
    low = std::max(low, 1e-3 * high);
  }

  double tension(double share) const { return low * std::pow(high / low, share); }
  double share(double tension) const {
    return std::clamp(std::log(std::max(tension, low) / low) / std::log(high / low), 0.0, 1.0);
  }
};

// Blue, cyan, green, yellow, red.
std_msgs::ColorRGBA colour(double share) {
  const auto ramp = [&](double centre) { return std::clamp(1.5 - std::abs(0.5 + 3.0 * share - centre), 0.0, 1.0); };
  const auto light = [&](double centre) { return 0.2 + 0.8 * ramp(centre); };
  return rgba(light(3.0), light(2.0), light(1.0), 1.0);
}

Marker marker(const std_msgs::Header& header, const char* space, std::size_t id, int type) {
  Marker m;
  m.header = header;
  m.ns = space;
  m.id = static_cast<std::int32_t>(id);
  m.type = type;
  m.action = Marker::ADD;
  m.pose.orientation.w = 1.0;
  return m;
}

Marker label(const std_msgs::Header& header, const char* space, std::size_t id, const std::string& words,
             const Eigen::Vector3d& position, double height, const std_msgs::ColorRGBA& color) {
  Marker m = marker(header, space, id, Marker::TEXT_VIEW_FACING);
  m.text = words;
  m.pose.position = toPoint(position);
  m.scale.z = height;
  m.color = color;
  return m;
}

std::string inNewton(double tension) {
  char words[32];
  std::snprintf(words, sizeof words, std::abs(tension) < 9.95 ? "%.1f N" : "%.0f N", tension);
  return words;
}

std_msgs::ColorRGBA colourOf(const CableState& cable, bool outlier, const TensionScale& scale) {
  if (outlier) return rgba(1.0, 0.0, 1.0, 1.0);
  if (cable.condition == CableState::COMPRESSED) return rgba(1.0, 1.0, 1.0, 1.0);
  return colour(scale.share(cable.tension_a));
}

std::vector<geometry_msgs::Point> lineOf(const CableDescription& cable, const CableState& state, const Pose& pose) {
  if (state.profile.size() >= 2) return state.profile;
  return {toPoint(cable.anchor), toPoint(pose.transform(cable.attachment))};
}

// Beside the anchor that lies furthest from the middle, one entry above the other.
void addLegend(const RobotDescription& robot, const KinetostaticState& state, const TensionScale& scale,
               visualization_msgs::MarkerArray* markers) {
  const double height = kTextHeight * robot.span();
  Eigen::Vector3d corner = robot.cables[0].anchor;
  for (const CableDescription& cable : robot.cables) corner = corner.cwiseMax(cable.anchor);
  corner.z() += 2.0 * height;
  for (int k = 0; k < kLegendEntries; ++k) {
    const double share = k / (kLegendEntries - 1.0);
    markers->markers.push_back(label(state.header, "legend", static_cast<std::size_t>(k),
                                     inNewton(scale.tension(share)),
                                     corner + Eigen::Vector3d(0.0, 0.0, k * 1.4 * height), height, colour(share)));
  }
  markers->markers.push_back(label(state.header, "legend", kLegendEntries, "tension at A",
                                   corner + Eigen::Vector3d(0.0, 0.0, kLegendEntries * 1.4 * height), height,
                                   rgba(0.6, 0.6, 0.6, 1.0)));
}

}  // namespace

std_msgs::ColorRGBA rgba(double red, double green, double blue, double alpha) {
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(red);
  color.g = static_cast<float>(green);
  color.b = static_cast<float>(blue);
  color.a = static_cast<float>(alpha);
  return color;
}

Marker platformMarker(const RobotDescription& robot, const std_msgs::Header& header, const geometry_msgs::Pose& pose) {
  Marker m = marker(header, "platform", 0, Marker::CUBE);
  Eigen::Vector3d low = robot.cables[0].attachment;
  Eigen::Vector3d high = low;
  for (const CableDescription& cable : robot.cables) {
    low = low.cwiseMin(cable.attachment);
    high = high.cwiseMax(cable.attachment);
  }
  m.pose = pose;
  m.pose.position = toPoint(fromMsg(pose).transform(0.5 * (low + high)));
  m.scale = toVector3(robot.size);
  m.color = rgba(0.5, 0.6, 0.75, 0.85);
  return m;
}

visualization_msgs::MarkerArray cableMarkers(const RobotDescription& robot, const KinetostaticState& state) {
  visualization_msgs::MarkerArray markers;
  const TensionScale scale(robot);
  const Pose pose = fromMsg(state.pose.pose);
  for (std::size_t i = 0; i < state.cables.size(); ++i) {
    const CableState& cable = state.cables[i];
    const bool outlier = state.outlier[i] != 0;
    Marker line = marker(state.header, "cables", i, Marker::LINE_STRIP);
    line.points = lineOf(robot.cables[i], cable, pose);
    line.scale.x = kLineWidth * robot.span();
    line.color = colourOf(cable, outlier, scale);
    markers.markers.push_back(line);

    const Eigen::Vector3d anchor = robot.cables[i].anchor;
    const Eigen::Vector3d middle = anchor + 0.35 * (pose.transform(robot.cables[i].attachment) - anchor);
    const std::string words = cable.name + " " + inNewton(cable.tension_a) + (outlier ? ", outlier" : "");
    markers.markers.push_back(
        label(state.header, "tensions", i, words, middle, 0.8 * kTextHeight * robot.span(), line.color));
  }
  addLegend(robot, state, scale, &markers);
  markers.markers.push_back(platformMarker(robot, state.header, state.pose.pose));
  return markers;
}

}  // namespace cdpr_kinetostatics
