#include "cdpr_kinetostatics/cable/model.h"

#include <gtest/gtest.h>

#include <string>

namespace cdpr_kinetostatics {
namespace {

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
