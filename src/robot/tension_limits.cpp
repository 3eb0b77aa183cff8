#include "robot/tension_limits.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "cable/tautness.h"

namespace cdpr_kinetostatics {
namespace {

// Cables keep this multiple of the least tension that can hold them.
constexpr double kAboveFold = 1.001;

// Below this multiple of the weight of a cable as long as its chord, its tension may come near the fold: the fold of a
// level cable lies at 0.75 times that weight.
constexpr double kNearFold = 3.0;

// A tension of zero has no answer to problem 3: the least one asked for, as a share of the upper limit.
constexpr double kLeastShare = 1e-12;

}  // namespace

CableSolution lengthAboveFold(const CableProperties& properties, double tension, const RungOptions& closed_form,
                              InverseCable* cable) {
  const CableSolution found = lengthOnRung(properties, cable->plane.x, cable->plane.y, tension, 0.0, closed_form);
  if (found.status.ok() || !(found.least_tension > 0.0)) return found;
  cable->lower = std::max(cable->lower, kAboveFold * found.least_tension);
  return lengthOnRung(properties, cable->plane.x, cable->plane.y, cable->lower, 0.0, closed_form);
}

bool isNearFold(const InverseCable& cable, double tension, const RungOptions& closed_form) {
  return !isStraight(closed_form.model) &&
         tension < kNearFold * cable.cable.properties().weight * std::hypot(cable.plane.x, cable.plane.y);
}

bool isBeyondFold(const InverseCable& cable, const RungOptions& closed_form) {
  return !isStraight(closed_form.model) && cable.by_tension.z() > 0.0 &&
         cable.cable.length() >= kHangingExcess * std::hypot(cable.plane.x, cable.plane.y);
}

bool anyAtFold(const std::vector<InverseCable>& cables, const Eigen::VectorXd& tensions,
               const RungOptions& closed_form) {
  for (std::size_t i = 0; i < cables.size(); ++i) {
    if (isBeyondFold(cables[i], closed_form)) return true;
    if (isNearFold(cables[i], tensions(static_cast<Eigen::Index>(i)), closed_form)) return true;
  }
  return false;
}

bool raiseLimitsToFolds(const RobotDescription& robot, const Eigen::VectorXd& tensions, const RungOptions& closed_form,
                        std::vector<InverseCable>* cables) {
  bool raised = false;
  for (std::size_t i = 0; i < cables->size(); ++i) {
    InverseCable& c = (*cables)[i];
    const double tension = tensions(static_cast<Eigen::Index>(i));
    if (!isNearFold(c, tension, closed_form)) continue;
    const CableSolution at = lengthOnRung(robot.cables[i].properties, c.plane.x, c.plane.y,
                                          std::max(tension, kLeastShare * c.upper), 0.0, closed_form);
    if (at.status.ok() || at.least_tension <= c.lower) continue;
    c.lower = kAboveFold * at.least_tension;
    raised = true;
  }
  return raised;
}

bool pullBackFromFolds(const RobotDescription& robot, const RungOptions& closed_form,
                       std::vector<InverseCable>* cables) {
  bool any = false;
  for (std::size_t i = 0; i < cables->size(); ++i) {
    InverseCable& c = (*cables)[i];
    if (!isBeyondFold(c, closed_form)) continue;
    const CableSolution taut = lengthAboveFold(robot.cables[i].properties, c.cable.tensionA(), closed_form, &c);
    if (!taut.status.ok()) continue;
    c.cable.start(taut.length, {taut.horizontal_force, taut.vertical_force_a});
    any = true;
  }
  return any;
}

Status contradiction(const RobotDescription& robot, const std::vector<InverseCable>& cables,
                     const TensionDistribution& distribution) {
  std::ostringstream text;
  text << "no tensions within the limits balance the load at this pose; these limits cannot all be met:";
  const char* separator = " ";
  const auto n = static_cast<int>(cables.size());  // behind the tensions a free attitude has limits of its own
  for (const int i : distribution.at_lower) {
    if (i >= n) continue;
    const bool fold = cables[i].lower > robot.cables[i].tension_min;
    text << separator << "'" << robot.cables[i].name << "' "
         << (fold ? "least tension that can hold the cable " : "tension_min ") << cables[i].lower << " N";
    separator = ", ";
  }
  for (const int i : distribution.at_upper) {
    if (i >= n) continue;
    text << separator << "'" << robot.cables[i].name << "' tension_max " << cables[i].upper << " N";
    separator = ", ";
  }
  return {Code::kInfeasible, text.str()};
}

}  // namespace cdpr_kinetostatics
