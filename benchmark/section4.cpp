// The paper's section 4 (docs/section4.md): the point mass on two cables, and platforms on six and eight of them.
//
//     section4 DIRECTORY [--quick]
//
// Writes two_cables.csv and platforms.csv into the directory and prints a summary. --quick: fewer points.
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "robot_cases.h"
#include "support/section4_platforms.h"
#include "support/section4_two_cables.h"

namespace cdpr_kinetostatics {
namespace {

std::ofstream csvFile(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw std::runtime_error("cannot write '" + path + "'");
  file.precision(15);
  return file;
}

void run(const std::string& directory, bool quick) {
  const RobotDescription robot = shippedRobot(ROBOT_DIR, "paper_point_mass");
  std::ofstream two_cables = csvFile(directory + "/two_cables.csv");
  sweepTwoCables(robot, quick, &two_cables);
  std::ofstream platforms = csvFile(directory + "/platforms.csv");
  sweepPlatforms(robot, quick, &platforms);
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  const bool quick = argc == 3 && std::strcmp(argv[2], "--quick") == 0;
  if (argc != 2 && !quick) {
    std::cerr << "usage: section4 DIRECTORY [--quick]\n";
    return 2;
  }
  try {
    cdpr_kinetostatics::run(argv[1], quick);
  } catch (const std::exception& problem) {
    std::cerr << "section4: " << problem.what() << "\n";
    return 1;
  }
  return 0;
}
