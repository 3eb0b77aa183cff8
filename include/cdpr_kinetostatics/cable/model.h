// The ladder of cable models, from a straight line to bending with stretch (docs/theory.md section 2).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace cdpr_kinetostatics {

// Ordered from coarsest to finest; the numbers are those of SolverOptions.msg.
enum class Model : std::uint8_t {
  kDefault = 0,
  kAuto = 1,
  kStraight = 2,
  kStraightElastic = 3,
  kCatenaryInextensible = 4,
  kCatenary = 5,
  kCatenaryCorrected = 6,
  kBendingInextensible = 7,
  kBending = 8,
};

inline bool isStraight(Model model) { return model == Model::kStraight || model == Model::kStraightElastic; }
inline bool isCatenary(Model model) { return model == Model::kCatenaryInextensible || model == Model::kCatenary; }
inline bool isBending(Model model) { return model == Model::kBendingInextensible || model == Model::kBending; }
inline bool isInextensible(Model model) {
  return model == Model::kStraight || model == Model::kCatenaryInextensible || model == Model::kBendingInextensible;
}

// The rung itself if it has a closed form; the catenary that a bending rung starts from.
inline Model closedFormRung(Model model) {
  if (!isBending(model)) return model;
  return isInextensible(model) ? Model::kCatenaryInextensible : Model::kCatenary;
}

// "straight", ..., "bending": the values of the node's ~model parameter.
const char* modelName(Model model);
std::optional<Model> modelFromName(const std::string& name);

}  // namespace cdpr_kinetostatics
