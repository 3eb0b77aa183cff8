// Which rung and tolerance to use on a robot, from what was measured on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tradeoff/measurement.h"

namespace cdpr_kinetostatics {

// Errors at the platform that recommendations are made for [m].
constexpr double kAccuracies[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6};

// What counts for a choice: the larger of the errors that forward (seeded 10 mm away) and inverse make at the
// platform, and forward's time.
struct Choice {
  Setting setting;
  double error = 0.0;  // [m]
  double time = 0.0;   // [s]
};

// Every setting that solved all poses.
std::vector<Choice> choicesOf(const RobotTrade& trade);

// The fastest model and tolerance within the accuracy [m], AUTO left aside. Empty if there is none.
std::optional<Choice> fastestWithin(const std::vector<Choice>& choices, double accuracy);

// "For 0.1 mm at the platform: catenary ...", what it neglects and takes, and what a coarser rung would miss at best.
std::string recommendation(const RobotTrade& trade, double accuracy);

}  // namespace cdpr_kinetostatics
