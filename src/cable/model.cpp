#include "cdpr_kinetostatics/cable/model.h"

#include <array>

namespace cdpr_kinetostatics {
namespace {

constexpr std::array<const char*, kRungs.size() + 2> kNames = {"default",
                                                               "auto",
                                                               "straight",
                                                               "straight_elastic",
                                                               "catenary_inextensible",
                                                               "catenary",
                                                               "catenary_corrected",
                                                               "bending_inextensible",
                                                               "bending"};

}  // namespace

const char* modelName(Model model) {
  const auto index = static_cast<std::size_t>(model);
  return index < kNames.size() ? kNames[index] : "unknown";
}

std::optional<Model> modelFromName(const std::string& name) {
  for (std::size_t i = static_cast<std::size_t>(Model::kAuto); i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<Model>(i);
  }
  return std::nullopt;
}

std::string modelNames() {
  std::string names = modelName(Model::kAuto);
  for (const Model model : kRungs) names += (model == kRungs.back() ? " or " : ", ") + std::string(modelName(model));
  return names;
}

}  // namespace cdpr_kinetostatics
