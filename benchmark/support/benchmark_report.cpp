#include "support/benchmark_report.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>

namespace cdpr_kinetostatics {

BenchmarkReport::BenchmarkReport(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--quick") == 0) {
      quick_ = true;
    } else if (std::strcmp(argv[i], "--csv") == 0 && i + 1 < argc) {
      path_ = argv[++i];
    } else {
      std::cerr << "usage: " << argv[0] << " [--quick] [--csv FILE]\n";
      std::exit(2);
    }
  }
}

void BenchmarkReport::atMost(int item, const std::string& quantity, double measured, double target) {
  rows_.push_back({item, quantity, measured, "", "<=", target});
}

void BenchmarkReport::atLeast(int item, const std::string& quantity, double measured, double target) {
  rows_.push_back({item, quantity, measured, "", ">=", target});
}

void BenchmarkReport::figure(int item, const std::string& quantity, double measured, const std::string& unit) {
  rows_.push_back({item, quantity, measured, unit, "", 0.0});
}

int BenchmarkReport::finish() const {
  for (const Row& row : rows_) {
    std::printf("%d  %-78s %10.4g %s", row.item, row.quantity.c_str(), row.measured, row.unit.c_str());
    if (!row.relation.empty()) {
      const bool met = row.relation == "<=" ? row.measured <= row.target : row.measured >= row.target;
      std::printf(" (%s %g: %s)", row.relation.c_str(), row.target, met ? "met" : "missed");
    }
    std::printf("\n");
  }
  if (path_.empty()) return 0;
  std::ofstream file(path_);
  file << "item,quantity,measured,unit,relation,target\n";
  for (const Row& row : rows_) {
    file << row.item << ",\"" << row.quantity << "\"," << row.measured << "," << row.unit << "," << row.relation << ",";
    if (!row.relation.empty()) file << row.target;
    file << "\n";
  }
  if (file.flush()) return 0;
  std::cerr << "cannot write " << path_ << "\n";
  return 1;
}

}  // namespace cdpr_kinetostatics
