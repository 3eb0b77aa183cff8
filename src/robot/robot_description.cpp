#include "cdpr_kinetostatics/robot/robot_description.h"

#include <algorithm>

namespace cdpr_kinetostatics {
namespace {

// Share of the span below which no attachment is told from the platform's origin.
constexpr double kLeastLever = 1e-6;

}  // namespace

double RobotDescription::span() const {
  double largest = 0.0;
  for (std::size_t i = 0; i < cables.size(); ++i) {
    for (std::size_t j = i + 1; j < cables.size(); ++j) {
      largest = std::max(largest, (cables[i].anchor - cables[j].anchor).norm());
    }
  }
  if (largest > 0.0) return largest;
  for (const CableDescription& cable : cables) largest = std::max(largest, (home.position - cable.anchor).norm());
  return largest;
}

double RobotDescription::lever() const { return std::max(platformRadius(), kLeastLever * span()); }

double RobotDescription::platformRadius() const {
  double largest = 0.0;
  for (const CableDescription& cable : cables) largest = std::max(largest, cable.attachment.norm());
  return largest;
}

}  // namespace cdpr_kinetostatics
