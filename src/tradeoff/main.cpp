// tradeoff: how fast and how exact is each cable model on a robot? (docs/trade.md)
#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "tradeoff/command_line.h"
#include "tradeoff/measurement.h"
#include "tradeoff/provenance.h"
#include "tradeoff/recommendation.h"
#include "tradeoff/report.h"
#include "tradeoff/shipped_robots.h"

namespace cdpr_kinetostatics {
namespace {

std::ofstream opened(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error("'" + path + "' cannot be written");
  return file;
}

void run(const CommandLine& line) {
  std::ofstream json, csv;
  if (!line.json.empty()) json = opened(line.json);
  if (!line.csv.empty()) csv = opened(line.csv);
  const Provenance origin = provenance();
  std::cout << origin.cores << " x " << origin.cpu << ", " << origin.compiler << ", " << origin.build_type
            << ", commit " << origin.commit << "\n"
            << "Errors: largest, against bending at " << kReferenceTolerance
            << ". Times: medians. *: not at all poses; "
            << "-: nowhere, or not known.\n\n";
  Effort effort = line.quick ? Effort::quick() : Effort::full();
  std::vector<double>& accuracies = effort.accuracies;
  if (std::find(accuracies.begin(), accuracies.end(), line.accuracy) == accuracies.end()) {
    accuracies.push_back(line.accuracy);
  }
  std::vector<RobotTrade> trades;
  for (const std::string& file : line.robot.empty() ? shippedRobots() : std::vector<std::string>{line.robot}) {
    const LoadedRobot loaded = loadRobotFile(file);
    for (const std::string& warning : loaded.warnings) std::cerr << file << ": " << warning << "\n";
    trades.push_back(measureTrade(loaded.robot, effort));
    writeTable(trades.back(), &std::cout);
    std::cout << "\n";
    for (const double accuracy : kAccuracies) {
      if (accuracy != line.accuracy) std::cout << recommendation(trades.back(), accuracy) << ".\n";
    }
    std::cout << recommendation(trades.back(), line.accuracy) << ".\n\n" << std::flush;
  }
  if (json.is_open()) writeJson(origin, trades, &json);
  if (csv.is_open()) writeCsv(origin, trades, &csv);
  if (!json.flush() || !csv.flush()) throw std::runtime_error("the results could not be written");
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  try {
    const cdpr_kinetostatics::CommandLine line = cdpr_kinetostatics::parseCommandLine(argc, argv);
    if (line.help) {
      std::cout << cdpr_kinetostatics::usage();
    } else {
      cdpr_kinetostatics::run(line);
    }
  } catch (const std::exception& error) {
    std::cerr << "tradeoff: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
