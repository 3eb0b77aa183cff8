#include "ros/markers.h"

#include <algorithm>
#include <cmath>

#include "cable/text.h"
#include "robot/platform_statics.h"
#include "ros/conversions.h"

namespace cdpr_kinetostatics {

namespace {

using visualization_msgs::Marker;

// Sizes of what is drawn, in spans of the frame [-].
constexpr double kLineWidth = 0.0025;
constexpr double kTextHeight = 0.018;
constexpr double kLegendHeight = 0.14;
constexpr double kLoadLength = 0.12;  // of the arrow, if the load is the platform's weight alone

constexpr std::size_t kLegendEntries = 5;

// Straight pieces of what is round: of a rope on its pulley, and of a pulley.
constexpr int kArcSteps = 12;
constexpr int kCircleSteps = 32;

std_msgs::ColorRGBA rgba(double red, double green, double blue, double alpha) {
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(red);
  color.g = static_cast<float>(green);
  color.b = static_cast<float>(blue);
  color.a = static_cast<float>(alpha);
  return color;
}

std_msgs::ColorRGBA grey() { return rgba(0.75, 0.75, 0.75, 1.0); }

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

// Blue, cyan, green, yellow, red; light enough for a dark background.
std_msgs::ColorRGBA colour(double share) {
  const auto ramp = [&](double centre) { return std::clamp(1.5 - std::abs(0.5 + 3.0 * share - centre), 0.0, 1.0); };
  const auto light = [&](double centre) { return 0.3 + 0.7 * ramp(centre); };
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

// Of the box around the attachments, platform frame [m].
Eigen::Vector3d middleOf(const RobotDescription& robot) {
  Eigen::Vector3d low = robot.cables[0].attachment;
  Eigen::Vector3d high = low;
  for (const CableDescription& cable : robot.cables) {
    low = low.cwiseMin(cable.attachment);
    high = high.cwiseMax(cable.attachment);
  }
  return 0.5 * (low + high);
}

// The guide pulley of a cable: a circle in the cable's plane that the rope reaches at the anchor.
struct PulleyCircle {
  Eigen::Vector3d centre, to_anchor, up;  // both vectors are radii, the second where the rope gets to after a quarter

  // Turned from the anchor in the rope's sense by so much [rad].
  geometry_msgs::Point at(double angle) const {
    return toPoint(centre + std::cos(angle) * to_anchor + std::sin(angle) * up);
  }
};

PulleyCircle pulleyOf(const CableDescription& cable, const Pose& pose) {
  const GuidePulley& pulley = cable.properties.pulley;
  const Eigen::Vector3d inwards = pulley.radius * cablePlane(cable, pose).direction;
  const double sense = pulley.rope_from == RopeFrom::kBelow ? 1.0 : -1.0;
  return {cable.anchor + inwards, -inwards, sense * pulley.radius * Eigen::Vector3d::UnitZ()};
}

// From the anchor around the pulley, and freely on to the platform.
std::vector<geometry_msgs::Point> lineOf(const CableDescription& cable, const CableState& state, const Pose& pose) {
  std::vector<geometry_msgs::Point> line;
  if (cable.properties.pulley.radius > 0.0) {
    const PulleyCircle circle = pulleyOf(cable, pose);
    for (int k = 0; k < kArcSteps; ++k) line.push_back(circle.at(state.wrap_angle * k / kArcSteps));
  }
  if (state.profile.size() >= 2) {
    line.insert(line.end(), state.profile.begin(), state.profile.end());
  } else {
    line.push_back(state.departure);
    line.push_back(toPoint(pose.transform(cable.attachment)));
  }
  return line;
}

void addPulley(const CableDescription& cable, const std_msgs::Header& header, std::size_t id, const Pose& pose,
               double width, visualization_msgs::MarkerArray* markers) {
  if (cable.properties.pulley.radius == 0.0) return;
  Marker circle = marker(header, "pulleys", id, Marker::LINE_STRIP);
  circle.scale.x = width;
  circle.color = grey();
  const PulleyCircle pulley = pulleyOf(cable, pose);
  for (int k = 0; k <= kCircleSteps; ++k) circle.points.push_back(pulley.at(2.0 * M_PI * k / kCircleSteps));
  markers->markers.push_back(circle);
}

// A bar of all colours and what they mean, above the middle of the frame.
void addLegend(const RobotDescription& robot, const std_msgs::Header& header, const TensionScale& scale,
               visualization_msgs::MarkerArray* markers) {
  const double span = robot.span();
  const double height = kTextHeight * span;
  Eigen::Vector3d low = robot.cables[0].anchor;
  Eigen::Vector3d high = low;
  for (const CableDescription& cable : robot.cables) {
    low = low.cwiseMin(cable.anchor);
    high = high.cwiseMax(cable.anchor);
  }
  const Eigen::Vector3d foot(0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), high.z() + 2.0 * height);
  const auto at = [&](double share) -> Eigen::Vector3d {
    return foot + share * kLegendHeight * span * Eigen::Vector3d::UnitZ();
  };
  constexpr int kSteps = 24;
  Marker bar = marker(header, "legend", 0, Marker::LINE_STRIP);
  bar.scale.x = 0.6 * height;
  for (int k = 0; k <= kSteps; ++k) {
    const double share = k / static_cast<double>(kSteps);
    bar.points.push_back(toPoint(at(share)));
    bar.colors.push_back(colour(share));
  }
  markers->markers.push_back(bar);
  for (std::size_t k = 0; k < kLegendEntries; ++k) {
    const double share = static_cast<double>(k) / (kLegendEntries - 1.0);
    const Eigen::Vector3d beside = at(share) + 3.0 * height * Eigen::Vector3d::UnitX();
    markers->markers.push_back(label(header, "legend", k + 1, inNewton(scale.tension(share)), beside, height, grey()));
  }
  markers->markers.push_back(label(header, "legend", kLegendEntries + 1, "tension at A",
                                   at(1.0 + 1.6 * kTextHeight / kLegendHeight), height, grey()));
}

// A post below each anchor, to the floor.
Marker framePosts(const RobotDescription& robot, const std_msgs::Header& header) {
  Marker posts = marker(header, "frame", 0, Marker::LINE_LIST);
  posts.scale.x = 0.6 * kLineWidth * robot.span();
  posts.color = rgba(0.45, 0.45, 0.45, 1.0);
  double floor = 0.0;
  for (const CableDescription& cable : robot.cables) floor = std::min(floor, cable.anchor.z());
  for (const CableDescription& cable : robot.cables) {
    posts.points.push_back(toPoint(cable.anchor));
    posts.points.push_back(toPoint({cable.anchor.x(), cable.anchor.y(), floor}));
  }
  return posts;
}

// The force that the cables hold, from the centre of mass: the platform's weight and the load.
void addLoad(const RobotDescription& robot, const KinetostaticState& state, const Pose& pose,
             visualization_msgs::MarkerArray* markers) {
  const Eigen::Vector3d load(state.load.force.x, state.load.force.y, state.load.force.z);
  const Eigen::Vector3d held = load - robot.weight() * Eigen::Vector3d::UnitZ();
  const double scale = kLoadLength * robot.span() / robot.weight();
  const Eigen::Vector3d start = pose.transform(robot.com);
  Marker arrow = marker(state.header, "load", 0, Marker::ARROW);
  arrow.points = {toPoint(start), toPoint(start + scale * held)};
  arrow.scale.x = 2.0 * kLineWidth * robot.span();
  arrow.scale.y = 3.0 * arrow.scale.x;
  arrow.scale.z = 4.0 * arrow.scale.x;
  arrow.color = rgba(1.0, 0.55, 0.1, 1.0);
  markers->markers.push_back(arrow);
  const double height = kTextHeight * robot.span();
  const Eigen::Vector3d beside = start + 0.6 * scale * held + 6.0 * height * Eigen::Vector3d::UnitX();
  const std::string words = text("weight and load ", inNewton(held.norm()), "\nload alone ", inNewton(load.norm()));
  markers->markers.push_back(label(state.header, "load", 1, words, beside, height, arrow.color));
}

}  // namespace

Marker platformMarker(const RobotDescription& robot, const std_msgs::Header& header, const geometry_msgs::Pose& pose) {
  Marker m = marker(header, "platform", 0, Marker::CUBE);
  m.pose = pose;
  m.pose.position = toPoint(fromMsg(pose).transform(middleOf(robot)));
  m.scale = toVector3(robot.size);
  m.color = rgba(0.45, 0.6, 0.85, 0.55);
  return m;
}

Marker platformOutline(const RobotDescription& robot, const std_msgs::Header& header, const geometry_msgs::Pose& pose) {
  Marker m = marker(header, "platform", 0, Marker::LINE_LIST);
  m.scale.x = 0.6 * kLineWidth * robot.span();
  m.color = rgba(0.2, 1.0, 0.3, 1.0);
  const Pose platform = fromMsg(pose);
  const auto corner = [&](int bits) {
    const Eigen::Array3d side(bits & 1 ? 0.5 : -0.5, bits & 2 ? 0.5 : -0.5, bits & 4 ? 0.5 : -0.5);
    return toPoint(platform.transform(middleOf(robot) + (side * robot.size.array()).matrix()));
  };
  for (int from = 0; from < 8; ++from) {
    for (const int axis : {1, 2, 4}) {
      if (from & axis) continue;
      m.points.push_back(corner(from));
      m.points.push_back(corner(from | axis));
    }
  }
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
    addPulley(robot.cables[i], state.header, i, pose, 0.6 * line.scale.x, &markers);

    // Cables often come in pairs: labels of neighbours go to different places along them.
    const double height = 0.9 * kTextHeight * robot.span();
    const Eigen::Vector3d anchor = robot.cables[i].anchor;
    Eigen::Vector3d beside =
        anchor + (i % 2 == 0 ? 0.22 : 0.45) * (pose.transform(robot.cables[i].attachment) - anchor);
    beside.z() += 1.5 * height;
    const std::string words = cable.name + " " + inNewton(cable.tension_a) + (outlier ? ", outlier" : "");
    markers.markers.push_back(label(state.header, "tensions", i, words, beside, height, line.color));
  }
  addLegend(robot, state.header, scale, &markers);
  addLoad(robot, state, pose, &markers);
  markers.markers.push_back(framePosts(robot, state.header));
  markers.markers.push_back(platformMarker(robot, state.header, state.pose.pose));
  return markers;
}

}  // namespace cdpr_kinetostatics
