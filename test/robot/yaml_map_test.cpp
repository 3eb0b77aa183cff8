#include "robot/yaml_map.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

namespace cdpr_kinetostatics {
namespace {

YamlMap mapOf(const std::string& yaml, const std::string& path = "winch") { return YamlMap(YAML::Load(yaml), path); }

std::string refusalOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

TEST(YamlMap, ReadsNumbersVectorsTextsAndMaps) {
  YamlMap map = mapOf("{mass: 2.5, xyz: [1, 2, 3], name: north, inner: {deep: 4}, list: [{a: 5}, {a: 6}]}");
  EXPECT_EQ(map.number("mass", Range::kPositive, "kg"), 2.5);
  EXPECT_EQ(map.optionalNumber("missing", Range::kPositive, "kg"), std::nullopt);
  EXPECT_EQ(map.vector("xyz", Range::kAny, "m"), Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(map.vectorOr("missing", Range::kAny, "m", Eigen::Vector3d::Ones()), Eigen::Vector3d::Ones());
  EXPECT_EQ(map.textOr("name", "south"), "north");
  EXPECT_EQ(map.textOr("missing", "south"), "south");
  EXPECT_EQ(map.map("inner").number("deep", Range::kAny, ""), 4.0);
  EXPECT_EQ(map.maps("list")[1].number("a", Range::kAny, ""), 6.0);
}

TEST(YamlMap, KnowsWhereItStands) {
  YamlMap map = mapOf("{inner: {deep: bad}, list: [{a: 1}, {a: bad}]}");
  EXPECT_EQ(map.pathOf("mass"), "winch.mass");
  EXPECT_EQ(mapOf("{}", "").pathOf("mass"), "mass");
  EXPECT_EQ(refusalOf([&] { map.map("inner").number("deep", Range::kAny, "m"); }),
            "winch.inner.deep = bad: expected a number, finite [m]");
  EXPECT_EQ(refusalOf([&] { map.maps("list")[1].number("a", Range::kAny, ""); }),
            "winch.list[1].a = bad: expected a number, finite");
}

TEST(YamlMap, RangesEndWhereTheySay) {
  YamlMap map = mapOf("{zero: 0, one: 1, more: 1.1, less: -1, infinite: .inf}");
  const auto refused = [&](const char* key, Range range) {
    return !refusalOf([&] { map.number(key, range, ""); }).empty();
  };
  EXPECT_TRUE(refused("zero", Range::kPositive));
  EXPECT_FALSE(refused("zero", Range::kNonNegative));
  EXPECT_TRUE(refused("less", Range::kNonNegative));
  EXPECT_FALSE(refused("less", Range::kAny));
  EXPECT_TRUE(refused("infinite", Range::kAny));
  EXPECT_FALSE(refused("one", Range::kFraction));
  EXPECT_TRUE(refused("more", Range::kFraction));
  EXPECT_TRUE(refused("zero", Range::kFraction));
}

TEST(YamlMap, RemembersWhatNothingAskedFor) {
  YamlMap map = mapOf("{a: 1, b: 2, c: 3}");
  static_cast<void>(map.has("a"));
  EXPECT_EQ(map.present({"b", "d"}), std::vector<std::string>{"winch.b"});
  EXPECT_EQ(map.unread(), std::vector<std::string>{"winch.c"});
}

TEST(YamlMap, LongValuesAreCutInMessages) {
  YamlMap map = mapOf("{mass: '" + std::string(500, 'x') + "'}");
  const std::string refusal = refusalOf([&] { map.number("mass", Range::kAny, "kg"); });
  EXPECT_LT(refusal.size(), 150U);
  EXPECT_NE(refusal.find("...: expected a number"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace cdpr_kinetostatics
