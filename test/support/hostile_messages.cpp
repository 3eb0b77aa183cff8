#include "hostile_messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cdpr_kinetostatics {
namespace {

using Values = std::vector<std::optional<double>>;

enum class Wrong { kScaled, kOneScaled, kNoisy, kSwapped, kMissing, kNotANumber, kHugeTensions, kTinyLength, kSeveral };
constexpr int kWrongs = 9;

int pick(int count, Dice* dice) {
  return std::min(count - 1, static_cast<int>(dice->uniform(0.0, static_cast<double>(count))));
}

// Over many orders of magnitude, or within a factor of two.
double factor(Dice* dice) {
  return dice->uniform(0.0, 1.0) < 0.5 ? std::pow(10.0, dice->uniform(-6.0, 6.0)) : dice->uniform(0.5, 2.0);
}

double& any(Values* values, Dice* dice) {
  return **std::next(values->begin(), pick(static_cast<int>(values->size()), dice));
}

void spoil(Wrong wrong, Dice* dice, Values* values) {
  const double one = factor(dice);
  switch (wrong) {
    case Wrong::kScaled:
      for (auto& value : *values) *value *= one;
      break;
    case Wrong::kOneScaled:
      any(values, dice) *= one;
      break;
    case Wrong::kNoisy: {
      const double share = std::pow(10.0, dice->uniform(-4.0, 0.0));
      for (auto& value : *values) *value *= 1.0 + share * dice->normal();
      break;
    }
    case Wrong::kSwapped:
      std::swap(any(values, dice), any(values, dice));
      break;
    case Wrong::kMissing:
      for (auto& value : *values) {
        if (dice->uniform(0.0, 1.0) < 0.5) value.reset();
      }
      break;
    case Wrong::kNotANumber:
      any(values, dice) = std::numeric_limits<double>::quiet_NaN();
      break;
    case Wrong::kHugeTensions:
      for (auto& value : *values) *value *= dice->normal() * std::pow(10.0, dice->uniform(0.0, 9.0));
      break;
    case Wrong::kTinyLength:
      any(values, dice) = std::pow(10.0, dice->uniform(-120.0, 0.0));
      break;
    case Wrong::kSeveral:
      for (auto& value : *values) {
        if (dice->uniform(0.0, 1.0) < 0.4) *value *= dice->uniform(0.9, 1.3);
      }
      break;
  }
}

}  // namespace

CableMeasurements hostileMessage(const CableMeasurements& good, Dice* dice) {
  CableMeasurements bad = good;
  const int which = pick(3, dice);  // lengths, tensions, both
  if (which != 1) spoil(static_cast<Wrong>(pick(kWrongs, dice)), dice, &bad.lengths);
  if (which != 0) spoil(static_cast<Wrong>(pick(kWrongs, dice)), dice, &bad.tensions);
  return bad;
}

void mistreat(const SimulatedRobot& robot, const CableMeasurements& good, Dice* dice, PoseEstimator* estimator) {
  const int messages = 1 + pick(5, dice);
  for (int k = 0; k < messages; ++k) {
    if (dice->uniform(0.0, 1.0) < 0.2) {
      Pose seed = robot.robot.home;
      seed.position += dice->uniform(0.0, 1.0) * robot.robot.span() * dice->direction();
      seed.orientation = dice->attitude();
      estimator->setPose(seed);
    } else {
      static_cast<void>(estimator->update(hostileMessage(good, dice)));
    }
  }
}

}  // namespace cdpr_kinetostatics
