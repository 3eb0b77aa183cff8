#include "suspended_platform.h"

#include <cmath>
#include <string>

namespace cdpr_kinetostatics {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRing = 4.0;        // radius of the polygon of anchors [m]
constexpr double kPlatform = 1.0;    // radius of the polygon of attachments [m]
constexpr double kHomeLength = 4.5;  // [m]

}  // namespace

RobotDescription suspendedPlatform(const RobotDescription& like, int corners, double load) {
  RobotDescription robot = like;
  robot.name = "platform_" + std::to_string(2 * corners);
  robot.type = PlatformType::kRigidBody;
  robot.mass = load / robot.gravity;
  robot.cables.clear();
  const double half_corner = kPi / corners;
  for (int i = 0; i < 2 * corners; ++i) {
    const int corner = i / 2;
    const double at_anchor = 2.0 * half_corner * corner;
    const double at_platform = at_anchor + (i % 2 == 0 ? -half_corner : half_corner);
    CableDescription cable = like.cables[0];
    cable.name = "cable" + std::to_string(i);
    cable.anchor << kRing * std::cos(at_anchor), kRing * std::sin(at_anchor), 0.0;
    cable.attachment << kPlatform * std::cos(at_platform), kPlatform * std::sin(at_platform), 0.0;
    robot.cables.push_back(cable);
  }
  const double across = (robot.cables[0].attachment - robot.cables[0].anchor).norm();
  robot.home = Pose();
  robot.home.position.z() = -std::sqrt(kHomeLength * kHomeLength - across * across);
  return robot;
}

}  // namespace cdpr_kinetostatics
