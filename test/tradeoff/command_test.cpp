// The program as its users run it: what it writes, and how it refuses.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace {

using nlohmann::json;

const std::string kRobot = ROBOT_DIR "/desktop_music_wire.yaml";

const std::string kJsonFile = testing::TempDir() + "tradeoff_test.json";

struct Reply {
  int exit_code = -1;
  std::string output;  // both streams
};

Reply replyOf(const std::string& command) {
  Reply run;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return run;
  char buffer[4096];
  while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe)) run.output.append(buffer, count);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  return run;
}

Reply tradeoff(const std::string& arguments) { return replyOf(std::string(TRADEOFF_EXECUTABLE) + " " + arguments); }

int linesOf(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class QuickRun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::string csv_file = testing::TempDir() + "tradeoff_test.csv";
    run_ = tradeoff("--quick --robot " + kRobot + " --json " + kJsonFile + " --csv " + csv_file);
    document_ = json::parse(contentOf(kJsonFile), nullptr, false);
    csv_ = contentOf(csv_file);
  }

  void SetUp() override {
    ASSERT_EQ(run_.exit_code, 0) << run_.output;
    ASSERT_FALSE(document_.is_discarded());
    ASSERT_EQ(document_["robots"].size(), 1u);
  }

  static std::vector<json> rowsOf(const std::string& model, const std::string& problem) {
    std::vector<json> rows;
    for (const json& row : document_["robots"][0]["rows"]) {
      if (row["model"] == model && row["problem"] == problem) rows.push_back(row);
    }
    return rows;
  }

  static Reply run_;
  static json document_;
  static std::string csv_;
};
Reply QuickRun::run_;
json QuickRun::document_;
std::string QuickRun::csv_;

TEST_F(QuickRun, SaysWhereItsNumbersComeFrom) {
  for (const char* key : {"cpu", "compiler", "build_type", "commit"}) {
    EXPECT_FALSE(document_["machine"][key].get<std::string>().empty()) << key;
    EXPECT_NE(csv_.find(document_["machine"][key].get<std::string>()), std::string::npos) << key;
  }
}

TEST_F(QuickRun, MeasuresEveryRungOnEveryProblem) {
  std::map<std::string, std::set<std::string>> problems;
  for (const json& row : document_["robots"][0]["rows"]) {
    problems[row["model"]].insert(row["problem"].get<std::string>());
    if (row["solved"] == 0) continue;
    EXPECT_GT(row["median_time"], 0.0) << row;
    EXPECT_GE(row["p99_time"], row["median_time"]) << row;
  }
  for (const char* model : {"straight", "straight_elastic", "catenary_inextensible", "catenary", "catenary_corrected",
                            "bending_inextensible", "bending"}) {
    EXPECT_EQ(problems[model].size(), 7u) << model;
  }
  const auto comments = static_cast<std::size_t>(std::count(csv_.begin(), csv_.end(), '#'));
  EXPECT_EQ(static_cast<std::size_t>(linesOf(csv_)), comments + 1 + document_["robots"][0]["rows"].size());
}

TEST_F(QuickRun, ErrorsOfBendingFallWithTheToleranceAndTheWorkGrows) {
  for (const char* problem : {"forward_cold", "forward_warm", "inverse", "estimate"}) {
    const std::vector<json> rows = rowsOf("bending", problem);
    ASSERT_EQ(rows.size(), 3u);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i]["solved"], rows[i]["trials"]) << rows[i];
      if (i == 0) continue;
      EXPECT_LT(rows[i]["tolerance"], rows[i - 1]["tolerance"]);
      EXPECT_LT(rows[i]["position_error"], rows[i - 1]["position_error"]) << rows[i];
      EXPECT_GT(rows[i]["evaluations"], rows[i - 1]["evaluations"]) << rows[i];
    }
    EXPECT_LT(rows.back()["position_error"], 1e-9);
  }
}

TEST_F(QuickRun, AutoStaysWithinItsAccuracy) {
  for (const char* problem : {"forward_cold", "forward_warm", "inverse", "cable_position", "cable_length"}) {
    const std::vector<json> rows = rowsOf("auto", problem);
    ASSERT_EQ(rows.size(), 2u) << problem;
    for (const json& row : rows) {
      EXPECT_EQ(row["solved"], row["trials"]) << row;
      EXPECT_LE(row["position_error"], row["accuracy"]) << row;
    }
    EXPECT_GE(rows[1]["evaluations"], rows[0]["evaluations"]) << problem;
  }
}

// A catenary has its modelling error, whatever the tolerance.
TEST_F(QuickRun, TheCatenaryMissesWhatBendingIsWorth) {
  for (const json& row : rowsOf("catenary", "forward_warm")) {
    EXPECT_GT(row["position_error"], 1e-6);
    EXPECT_LT(row["position_error"], 1e-4);
    EXPECT_EQ(row["evaluations"], 0.0);
  }
}

TEST_F(QuickRun, RecommendsTheFastestThatIsGoodEnough) {
  for (const json& recommendation : document_["robots"][0]["recommendations"]) {
    const std::string sentence = recommendation["sentence"];
    EXPECT_NE(run_.output.find(sentence + ".\n"), std::string::npos) << sentence;
    ASSERT_TRUE(recommendation["model"].is_string()) << sentence;
    EXPECT_LE(recommendation["error"], recommendation["accuracy"]);
    EXPECT_NE(sentence.find("use " + recommendation["model"].get<std::string>()), std::string::npos) << sentence;
  }
  // Nothing but bending is exact to a micrometre on wires of few bending layers.
  EXPECT_EQ(document_["robots"][0]["recommendations"].back()["accuracy"], 1e-6);
  EXPECT_EQ(document_["robots"][0]["recommendations"].back()["model"], "bending");
  const std::size_t last = run_.output.rfind("For errors up to ");
  EXPECT_EQ(run_.output.find("100 um", last), last + std::string("For errors up to ").size());
}

TEST_F(QuickRun, IsDrawn) {
  const std::string pictures = testing::TempDir() + "tradeoff_test_pictures";
  const Reply drawn = replyOf("/usr/bin/python3 " SOURCE_DIR "/scripts/studies/plot_tradeoff.py " + kJsonFile +
                              " --images " + pictures);
  EXPECT_EQ(drawn.exit_code, 0) << drawn.output;
  for (const char* problem : {"forward", "inverse", "estimate", "cable"}) {
    EXPECT_EQ(contentOf(pictures + "/trade_" + problem + ".png").substr(1, 3), "PNG") << problem;
  }
}

// Its cables have no bending layers to count.
TEST(WithoutFlexuralRigidity, IsMeasuredAndDrawn) {
  std::string robot = contentOf(ROBOT_DIR "/paper_point_mass.yaml");
  const std::string radius = "radius: 0.01\n  youngs_modulus: 1.7e+11\n  density: 8050.0\n";
  ASSERT_NE(robot.find(radius), std::string::npos);
  robot.replace(robot.find(radius), radius.size(),
                "axial_stiffness: 5.3e+7\n  bending_stiffness: 0.0\n  linear_density: 2.5\n");
  const std::string file = testing::TempDir() + "tradeoff_test_limp.yaml";
  std::ofstream(file) << robot;
  const std::string json_file = testing::TempDir() + "tradeoff_test_limp.json";
  const Reply run = tradeoff("--quick --robot " + file + " --json " + json_file);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(run.output.find("kappa L"), std::string::npos) << run.output;
  EXPECT_TRUE(json::parse(contentOf(json_file))["robots"][0]["kappa_length"].is_null());
  const Reply drawn = replyOf("/usr/bin/python3 " SOURCE_DIR "/scripts/studies/plot_tradeoff.py " + json_file +
                              " --images " + testing::TempDir() + "tradeoff_test_limp");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.output;
}

class Refusal : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(Refusal, IsASentenceAndExitCodeOne) {
  const Reply run = tradeoff("--quick " + GetParam().first);
  EXPECT_EQ(run.exit_code, 1);
  const std::size_t sentence = run.output.rfind("tradeoff: ");
  ASSERT_NE(sentence, std::string::npos) << run.output;
  EXPECT_NE(run.output.find(GetParam().second, sentence), std::string::npos) << run.output;
  EXPECT_EQ(linesOf(run.output.substr(sentence)), 1) << run.output;
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Refusal,
    testing::Values(std::pair("--robot missing.yaml", "missing.yaml: expected a file that can be read"),
                    std::pair("--rungs all", "unrecognised option '--rungs'"),
                    std::pair("--accuracy -1", "--accuracy must be a positive number"),
                    std::pair("--robot " + kRobot + " --json /nowhere/x.json", "'/nowhere/x.json' cannot be written"),
                    std::pair(kRobot, "too many positional options")));

TEST(Help, ListsTheOptions) {
  const Reply run = tradeoff("--help");
  EXPECT_EQ(run.exit_code, 0);
  for (const char* option : {"--robot", "--accuracy", "--quick", "--json", "--csv"}) {
    EXPECT_NE(run.output.find(option), std::string::npos) << option;
  }
}

}  // namespace
