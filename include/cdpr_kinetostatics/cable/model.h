// The ladder of cable models, from a straight line to bending with stretch (docs/theory.md section 2).
#pragma once

#include <array>
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

// The ladder's rungs, from coarsest to finest: every model that a cable can be solved with.
inline constexpr std::array kRungs = {Model::kStraight, Model::kStraightElastic,   Model::kCatenaryInextensible,
                                      Model::kCatenary, Model::kCatenaryCorrected, Model::kBendingInextensible,
                                      Model::kBending};

inline bool isStraight(Model model) { return model == Model::kStraight || model == Model::kStraightElastic; }
inline bool isCatenary(Model model) {
  return model == Model::kCatenaryInextensible || model == Model::kCatenary || model == Model::kCatenaryCorrected;
}
inline bool isBending(Model model) { return model == Model::kBendingInextensible || model == Model::kBending; }
inline bool isInextensible(Model model) {
  return model == Model::kStraight || model == Model::kCatenaryInextensible || model == Model::kBendingInextensible;
}

// The rung that a solve starts from: the catenary of the rungs that bend and of AUTO, otherwise the rung itself.
inline Model startingRung(Model model) {
  if (isStraight(model) || isInextensible(model)) {
    return isBending(model) ? Model::kCatenaryInextensible : model;
  }
  return Model::kCatenary;
}

// "straight", ..., "bending": the values of the node's ~model parameter.
const char* modelName(Model model);
std::optional<Model> modelFromName(const std::string& name);

// What may be asked for: "auto, straight, ... or bending", for sentences.
std::string modelNames();

}  // namespace cdpr_kinetostatics
