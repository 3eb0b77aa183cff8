#include "tradeoff/recommendation.h"

#include <gtest/gtest.h>

#include <string>

namespace cdpr_kinetostatics {
namespace {

// Rows of forward and inverse for a setting that solved all of three poses.
void add(RobotTrade* trade, const Setting& setting, double forward_error, double inverse_error, double time) {
  Row row;
  row.setting = setting;
  row.trials = row.solved = 3;
  row.problem = Problem::kForwardWarm;
  row.errors.position = forward_error;
  row.median_time = time;
  trade->rows.push_back(row);
  row.problem = Problem::kInverse;
  row.errors.position = inverse_error;
  row.median_time = 10.0 * time;
  trade->rows.push_back(row);
}

RobotTrade measured() {
  RobotTrade trade;
  add(&trade, {Model::kStraight, 1e-8, std::nullopt}, 3e-2, 5e-2, 1e-6);
  add(&trade, {Model::kCatenary, 1e-6, std::nullopt}, 2e-4, 1e-4, 10e-6);
  add(&trade, {Model::kCatenary, 1e-8, std::nullopt}, 2e-4, 1e-4, 11e-6);
  add(&trade, {Model::kCatenary, 1e-10, std::nullopt}, 2e-4, 1e-4, 20e-6);
  add(&trade, {Model::kBending, 1e-8, std::nullopt}, 1e-9, 1e-9, 200e-6);
  add(&trade, {Model::kAuto, 1e-8, 1e-3}, 3e-4, 2e-4, 15e-6);
  return trade;
}

TEST(Recommendation, AChoiceErrsByTheWorseOfForwardAndInverse) {
  const std::vector<Choice> choices = choicesOf(measured());
  ASSERT_EQ(choices.size(), 6u);
  EXPECT_EQ(choices[0].error, 5e-2);
  EXPECT_EQ(choices[1].error, 2e-4);
  EXPECT_EQ(choices[1].time, 10e-6);
}

TEST(Recommendation, WhatDidNotSolveAllPosesIsNoChoice) {
  RobotTrade trade = measured();
  trade.rows[3].solved = 2;  // the catenary's inverse at 1e-6
  trade.rows[8].errors.position.reset();
  const std::vector<Choice> choices = choicesOf(trade);
  ASSERT_EQ(choices.size(), 4u);
  EXPECT_EQ(choices[1].setting.tolerance, 1e-8);
  EXPECT_EQ(choices[3].setting.model, Model::kAuto);
}

TEST(Recommendation, TheFastestWithinTheAccuracyAtAToleranceThatCostsLittle) {
  const std::vector<Choice> choices = choicesOf(measured());
  const std::optional<Choice> choice = fastestWithin(choices, 1e-3);
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->setting.model, Model::kCatenary);
  EXPECT_EQ(choice->setting.tolerance, 1e-8);  // 10 % slower than 1e-6; 1e-10 takes twice as long
  EXPECT_EQ(fastestWithin(choices, 1e-6)->setting.model, Model::kBending);
  EXPECT_FALSE(fastestWithin(choices, 1e-12));
}

TEST(Recommendation, SaysWhatElseThereIs) {
  const std::string sentence = recommendation(measured(), 1e-3);
  for (const char* words : {"use catenary, tolerance 1e-08", "200 um neglected, 11 us", "straight would err by 50 mm",
                            "bending would take 200 us", "auto errs by 300 um in 15 us"}) {
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  }
  EXPECT_NE(recommendation(measured(), 1e-12).find("no rung is good enough"), std::string::npos);
}

}  // namespace
}  // namespace cdpr_kinetostatics
