// What a benchmark found: ratios beside their targets, for people and, as CSV, for scripts/benchmarks.sh.
#pragma once

#include <string>
#include <vector>

namespace cdpr_kinetostatics {

class BenchmarkReport {
 public:
  // Reads the command line of a benchmark: --quick (seconds, not minutes) and --csv FILE. Ends the program with a
  // usage line on anything else.
  BenchmarkReport(int argc, char** argv);

  bool quick() const { return quick_; }

  // item: the number in docs/performance.md. A target missed is reported, never an error.
  void atMost(int item, const std::string& quantity, double measured, double target);
  void atLeast(int item, const std::string& quantity, double measured, double target);
  // A figure without a target; unit "" for a ratio.
  void figure(int item, const std::string& quantity, double measured, const std::string& unit);

  // Prints the rows and writes the file; the program's exit code.
  int finish() const;

 private:
  struct Row {
    int item;
    std::string quantity;
    double measured;
    std::string unit;
    std::string relation;  // "<=", ">=", or nothing
    double target;
  };

  bool quick_ = false;
  std::string path_;
  std::vector<Row> rows_;
};

}  // namespace cdpr_kinetostatics
