// A CSV file, written row by row.
#pragma once

#include <fstream>
#include <iomanip>
#include <limits>
#include <stdexcept>
#include <string>

namespace cdpr_kinetostatics {

class CsvFile {
 public:
  // Throws if the file cannot be written.
  CsvFile(const std::string& path, const std::string& columns) : out_(path) {
    if (!out_) throw std::runtime_error(path + " cannot be written");
    out_ << columns << "\n" << std::setprecision(std::numeric_limits<double>::max_digits10);
  }

  template <typename First, typename... Rest>
  void row(const First& first, const Rest&... rest) {
    out_ << first;
    ((out_ << "," << rest), ...);
    out_ << "\n";
  }

 private:
  std::ofstream out_;
};

}  // namespace cdpr_kinetostatics
