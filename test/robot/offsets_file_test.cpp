// Offsets survive in their file, digit by digit; another robot's file is refused.
#include "robot/offsets_file.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "good_robot.h"

namespace cdpr_kinetostatics {
namespace {

class OffsetsFile : public testing::Test {
 protected:
  OffsetsFile() { std::remove(path_.c_str()); }
  ~OffsetsFile() override { std::remove(path_.c_str()); }

  std::string complaintOf(const std::string& text) {
    std::ofstream(path_) << text;
    try {
      readOffsets(path_, robot_);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  RobotDescription robot_ = parseRobot(goodRobot()).robot;
  const std::string path_ = testing::TempDir() + "offsets_file_test.yaml";
};

TEST_F(OffsetsFile, WhatIsWrittenIsReadDigitByDigit) {
  robot_.cables[1].name = "left/upper \"7\"";
  const std::vector<double> offsets = {0.1 + 0.2, -1.0 / 3.0e9, 123456.0};
  writeOffsets(path_, robot_, offsets);
  EXPECT_EQ(readOffsets(path_, robot_), offsets);
  writeOffsets(path_, robot_, {1.0, 2.0, 3.0});
  EXPECT_EQ(readOffsets(path_, robot_), (std::vector<double>{1.0, 2.0, 3.0})) << "the new one takes its place";
}

TEST_F(OffsetsFile, NothingIsLeftBesideIt) {
  writeOffsets(path_, robot_, {1.0, 2.0, 3.0});
  EXPECT_FALSE(std::ifstream(path_ + ".new").good());
}

TEST_F(OffsetsFile, AFileThatCannotBeWrittenIsNamed) {
  try {
    writeOffsets("/no/such/folder/offsets.yaml", robot_, {1.0, 2.0, 3.0});
    FAIL() << "was written";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "/no/such/folder/offsets.yaml")) << error.what();
  }
}

TEST_F(OffsetsFile, WhatIsNoneOrAnotherRobotsIsRefused) {
  EXPECT_TRUE(contains(complaintOf("robot: other\noffsets: []\n"), "robot = other: expected 'tester'"));
  EXPECT_TRUE(contains(complaintOf("robot: tester\noffsets: [{cable: cable0, offset: 1}]\n"), "for each of 3 cables"));
  const std::string rest = "{cable: east, offset: 0}, {cable: cable2, offset: 0}]\n";
  EXPECT_EQ(complaintOf("robot: tester\noffsets: [{cable: cable0, offset: 1}, " + rest), "");
  EXPECT_TRUE(contains(complaintOf("robot: tester\noffsets: [{cable: rope, offset: 1}, " + rest),
                       "offsets[0].cable = rope: expected 'cable0'"));
  EXPECT_TRUE(contains(complaintOf("robot: tester\noffsets: [{cable: cable0, offset: .nan}, " + rest),
                       "offsets[0].offset = .nan: expected a number, finite [m]"));
  EXPECT_TRUE(contains(complaintOf("robot: tester\noffsets: [{cable: cable0, offset: 1e9}, " + rest), "million"));
  EXPECT_TRUE(contains(complaintOf("[1, 2"), path_));
}

}  // namespace
}  // namespace cdpr_kinetostatics
