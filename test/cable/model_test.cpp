#include "cdpr_kinetostatics/cable/model.h"

#include <gtest/gtest.h>

#include <string>

namespace cdpr_kinetostatics {
namespace {

// A model that is added has its number, its name and its place on the ladder.
TEST(Model, TheLadderIsOrderedAndWhole) {
  std::uint8_t number = static_cast<std::uint8_t>(Model::kAuto);
  for (const Model model : kRungs) {
    EXPECT_EQ(static_cast<std::uint8_t>(model), ++number) << modelName(model);
    EXPECT_EQ(isStraight(model) + isCatenary(model) + isBending(model), 1) << modelName(model);
  }
  EXPECT_EQ(std::string(modelName(static_cast<Model>(number + 1))), "unknown");
  EXPECT_EQ(modelNames(),
            "auto, straight, straight_elastic, catenary_inextensible, catenary, catenary_corrected, "
            "bending_inextensible or bending");
}

TEST(Model, NamesComeBack) {
  for (int number = 1; number <= 8; ++number) {
    const Model model = static_cast<Model>(number);
    EXPECT_EQ(modelFromName(modelName(model)), model) << number;
  }
  EXPECT_FALSE(modelFromName("rope"));
  EXPECT_FALSE(modelFromName(""));
  EXPECT_EQ(std::string(modelName(Model::kCatenaryCorrected)), "catenary_corrected");
}

}  // namespace
}  // namespace cdpr_kinetostatics
