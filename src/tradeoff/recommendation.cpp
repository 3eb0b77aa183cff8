#include "tradeoff/recommendation.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "tradeoff/units.h"

namespace cdpr_kinetostatics {
namespace {

// A setting that takes at most this many times as long as the fastest is worth its finer tolerance [-].
constexpr double kSameTime = 1.25;

// Of the models coarser than this one, none of which is accurate enough, the setting that errs least.
std::optional<Choice> bestCoarser(const std::vector<Choice>& choices, Model model, double accuracy) {
  std::optional<Choice> best;
  for (const Choice& choice : choices) {
    const Model other = choice.setting.model;
    if (other == Model::kAuto || other >= model || choice.error <= accuracy) continue;
    if (!best || choice.error < best->error) best = choice;
  }
  return best;
}

}  // namespace

std::vector<Choice> choicesOf(const RobotTrade& trade) {
  const auto isComplete = [](const Row& row) { return row.solved == row.trials && row.errors.position; };
  const auto isSame = [](const Setting& a, const Setting& b) {
    return a.model == b.model && a.tolerance == b.tolerance && a.accuracy == b.accuracy;
  };
  std::vector<Choice> choices;
  for (const Row& forward : trade.rows) {
    if (forward.problem != Problem::kForwardWarm || !isComplete(forward)) continue;
    for (const Row& inverse : trade.rows) {
      if (inverse.problem != Problem::kInverse || !isComplete(inverse)) continue;
      if (!isSame(forward.setting, inverse.setting)) continue;
      choices.push_back(
          {forward.setting, std::max(*forward.errors.position, *inverse.errors.position), forward.median_time});
    }
  }
  return choices;
}

std::optional<Choice> fastestWithin(const std::vector<Choice>& choices, double accuracy) {
  std::optional<Choice> fastest;
  for (const Choice& choice : choices) {
    if (choice.setting.model == Model::kAuto || choice.error > accuracy) continue;
    if (!fastest || choice.time < fastest->time) fastest = choice;
  }
  if (!fastest) return std::nullopt;
  // Closed forms take about as long at any tolerance: the finest that costs little more is the better choice.
  const double affordable = kSameTime * fastest->time;
  for (const Choice& choice : choices) {
    if (choice.setting.model != fastest->setting.model || choice.error > accuracy || choice.time > affordable) continue;
    if (choice.setting.tolerance < fastest->setting.tolerance) fastest = choice;
  }
  return fastest;
}

std::string recommendation(const RobotTrade& trade, double accuracy) {
  const std::vector<Choice> choices = choicesOf(trade);
  const std::optional<Choice> choice = fastestWithin(choices, accuracy);
  std::ostringstream text;
  text << "For errors up to " << asLength(accuracy) << " at the platform ";
  if (!choice) {
    text << "no rung is good enough: ask for less";
    return text.str();
  }
  text << "use " << modelName(choice->setting.model) << ", tolerance " << choice->setting.tolerance << ": "
       << asLength(choice->error) << " neglected, " << asTime(choice->time);
  if (const std::optional<Choice> coarser = bestCoarser(choices, choice->setting.model, accuracy)) {
    text << "; " << modelName(coarser->setting.model) << " would err by " << asLength(coarser->error);
  }
  const auto bends = [](const Choice& other) { return other.setting.model == Model::kBending; };
  if (!bends(*choice)) {
    std::vector<Choice> bending;
    std::copy_if(choices.begin(), choices.end(), std::back_inserter(bending), bends);
    const std::optional<Choice> reference = fastestWithin(bending, accuracy);
    if (reference) text << "; bending would take " << asTime(reference->time);
  }
  for (const Choice& automatic : choices) {
    if (automatic.setting.accuracy != accuracy) continue;
    text << "; auto errs by " << asLength(automatic.error) << " in " << asTime(automatic.time);
  }
  return text.str();
}

}  // namespace cdpr_kinetostatics
