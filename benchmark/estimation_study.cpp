// What docs/estimation.md says of the pose estimator, measured on simulated robots: prints its tables and writes one
// CSV file for each experiment.
//
//     estimation_study [--quick] [--directory DIR] [--model MODEL] [EXPERIMENT...]

#include <boost/program_options.hpp>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>

#include "estimation_study/study.h"

using namespace cdpr_kinetostatics;
namespace po = boost::program_options;

int main(int argc, char** argv) {
  const std::map<std::string, void (*)(const Study&)> experiments = {{"consistency", studyConsistency},
                                                                     {"faults", studyFaults},
                                                                     {"load", studyLoadChange},
                                                                     {"observability", studyObservability},
                                                                     {"offsets", studyOffsets},
                                                                     {"recovery", studyRecovery},
                                                                     {"timing", studyTiming}};
  try {
    Study study;
    std::string model;
    std::vector<std::string> chosen;
    po::options_description options("Options");
    options.add_options()("help", "say this")                                               //
        ("quick", po::bool_switch(&study.quick), "seconds instead of minutes")              //
        ("directory", po::value(&study.directory)->default_value("."), "of the CSV files")  //
        ("model", po::value(&model)->default_value("catenary"),
         "cable model of robot and estimator; timing always takes catenary and bending")  //
        ("experiment", po::value(&chosen),
         "consistency, faults, load, observability, offsets, recovery, timing; none: all");
    po::variables_map values;
    po::positional_options_description positional;
    positional.add("experiment", -1);
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(), values);
    if (values.count("help") > 0) {
      std::cout << "estimation_study [OPTION...] [EXPERIMENT...]\n" << options;
      return EXIT_SUCCESS;
    }
    po::notify(values);
    const std::optional<Model> known = modelFromName(model);
    if (!known) throw std::invalid_argument("--model " + model + ": expected catenary or bending, for instance");
    study.model = *known;
    if (chosen.empty()) {
      for (const auto& experiment : experiments) chosen.push_back(experiment.first);
    }
    for (const std::string& name : chosen) {
      if (experiments.count(name) == 0) throw std::invalid_argument("there is no experiment " + name);
    }
    std::filesystem::create_directories(study.directory);
    for (const std::string& name : chosen) experiments.at(name)(study);
  } catch (const std::exception& problem) {
    std::cerr << "estimation_study: " << problem.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
