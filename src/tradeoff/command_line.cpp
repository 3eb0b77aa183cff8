#include "tradeoff/command_line.h"

#include <boost/program_options.hpp>
#include <sstream>
#include <stdexcept>

namespace cdpr_kinetostatics {
namespace {

namespace options = boost::program_options;

options::options_description described(CommandLine* line) {
  options::options_description all("Options");
  all.add_options()                                              //
      ("help,h", options::bool_switch(&line->help), "say this")  //
      ("robot", options::value(&line->robot)->value_name("FILE"),
       "description of the robot (docs/robots.md); without it, every robot that comes with the package")  //
      ("accuracy", options::value(&line->accuracy)->value_name("M")->default_value(line->accuracy, "1e-4"),
       "error at the platform that the recommendation accepts [m]")  //
      ("quick", options::bool_switch(&line->quick),
       "seconds instead of minutes: fewer poses, tolerances, repetitions")                              //
      ("json", options::value(&line->json)->value_name("FILE"), "write all that was measured as JSON")  //
      ("csv", options::value(&line->csv)->value_name("FILE"), "the same as CSV");
  return all;
}

}  // namespace

std::string usage() {
  CommandLine line;
  std::ostringstream text;
  text << "tradeoff: measures the error of every cable model against its time, on robots at poses around their home.\n"
       << described(&line);
  return text.str();
}

CommandLine parseCommandLine(int argc, char** argv) {
  CommandLine line;
  const options::options_description all = described(&line);
  try {
    options::variables_map values;
    options::store(options::command_line_parser(argc, argv).options(all).positional({}).run(), values);
    options::notify(values);
  } catch (const options::error& error) {
    throw std::invalid_argument(std::string(error.what()) + "; tradeoff --help lists the options");
  }
  if (!(line.accuracy > 0.0)) throw std::invalid_argument("--accuracy must be a positive number of metres");
  return line;
}

}  // namespace cdpr_kinetostatics
