// The options of the program.
#pragma once

#include <string>

namespace cdpr_kinetostatics {

struct CommandLine {
  bool help = false;
  bool quick = false;
  std::string robot;  // file; empty: every shipped robot
  std::string json;   // files to write; empty: none
  std::string csv;
  double accuracy = 1e-4;  // [m]
};

std::string usage();

// Throws std::invalid_argument, with a sentence, if an option is unknown or its value is not understood.
CommandLine parseCommandLine(int argc, char** argv);

}  // namespace cdpr_kinetostatics
