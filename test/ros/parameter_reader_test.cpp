#include "ros/parameter_reader.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "yaml_parameters.h"

namespace cdpr_kinetostatics {
namespace {

ParameterReader readerOf(const std::string& yaml) { return ParameterReader(toParameter(YAML::Load(yaml))); }

std::string refusalOf(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

TEST(ParameterReader, ReadsWhatIsThereAndElseTheFallback) {
  ParameterReader reader = readerOf("{number: 2.5, count: 7, flag: true, word: north, list: [1, 2.5]}");
  EXPECT_EQ(reader.number("number", 1.0, 0.0, 10.0, " m"), 2.5);
  EXPECT_EQ(reader.number("other_number", 1.0, 0.0, 10.0, " m"), 1.0);
  EXPECT_EQ(reader.integer("count", 1, 0, 10), 7);
  EXPECT_TRUE(reader.flag("flag", false));
  EXPECT_FALSE(reader.flag("other_flag", false));
  EXPECT_EQ(reader.word("word", "south"), "north");
  EXPECT_EQ(reader.oneOf("other_word", "south", {"north", "south"}), "south");
  EXPECT_EQ(reader.numbers("list", 2, 0.0, 3.0, ""), (std::vector<double>{1.0, 2.5}));
  EXPECT_TRUE(reader.numbers("other_list", 2, 0.0, 3.0, "").empty());
}

TEST(ParameterReader, TakesNumbersThatYamlReadsAsText) {
  EXPECT_EQ(asNumber(XmlRpc::XmlRpcValue("1e-8")), 1e-8);
  EXPECT_EQ(asNumber(XmlRpc::XmlRpcValue("1e-8 m")), std::nullopt);
  EXPECT_EQ(asNumber(XmlRpc::XmlRpcValue("")), std::nullopt);
  EXPECT_EQ(asNumber(XmlRpc::XmlRpcValue(true)), std::nullopt);
}

TEST(ParameterReader, RefusesWithKeyValueAndExpectation) {
  ParameterReader reader = readerOf("{number: 20, count: 2.5, flag: 1, word: east, list: [1, 9]}");
  EXPECT_EQ(refusalOf([&] { reader.number("number", 1.0, 0.0, 10.0, " m"); }),
            "parameter ~number is 20: expected a number from 0 to 10 m");
  EXPECT_EQ(refusalOf([&] { reader.integer("count", 1, 0, 10); }),
            "parameter ~count is 2.5: expected a whole number from 0 to 10");
  EXPECT_EQ(refusalOf([&] { reader.flag("flag", false); }), "parameter ~flag is 1: expected true or false");
  EXPECT_EQ(refusalOf([&] {
              reader.oneOf("word", "north", {"north", "south"});
            }),
            "parameter ~word is 'east': expected one of north, south");
  EXPECT_EQ(refusalOf([&] {
              reader.oneOf("kind", "", {"north", "south"});
            }),
            "parameter ~kind is missing: expected one of north, south");
  const std::string expected = "expected a list of 2 numbers from 0 to 3 N";
  EXPECT_NE(refusalOf([&] { reader.numbers("list", 2, 0.0, 3.0, " N"); }).find(expected), std::string::npos);
  EXPECT_NE(refusalOf([&] { reader.numbers("word", 2, 0.0, 3.0, " N"); }).find(expected), std::string::npos);
}

TEST(ParameterReader, NamesWhatNobodyAskedFor) {
  ParameterReader reader = readerOf("{rate: 1, rat: 2}");
  static_cast<void>(reader.number("rate", 1.0, 0.0, 10.0, ""));
  const std::vector<std::string> ignored = reader.ignored();
  ASSERT_EQ(ignored.size(), 1u);
  EXPECT_NE(ignored[0].find("~rat is unknown and ignored: the node's parameters are ~rate"), std::string::npos)
      << ignored[0];
}

}  // namespace
}  // namespace cdpr_kinetostatics
