#include "golden_cables.h"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace cdpr_kinetostatics {
namespace {

// Lines may end in CR LF.
std::vector<std::string> fields(std::string line) {
  while (!line.empty() && line.back() == '\r') line.pop_back();
  std::vector<std::string> result;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) result.push_back(field);
  return result;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const GoldenCable& golden) {
  return out << "row " << golden.row << " of cables.csv";
}

std::vector<GoldenCable> goldenCables(const std::string& directory) {
  const std::string file = directory + "/cables.csv";
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) throw std::runtime_error("cannot read " + file);
  const std::vector<std::string> names = fields(line);
  std::vector<GoldenCable> result;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = fields(line);
    if (values.size() != names.size()) throw std::runtime_error("a short line in " + file);
    std::map<std::string, double> value;
    for (std::size_t i = 0; i < names.size(); ++i) value[names[i]] = std::stod(values[i]);
    GoldenCable golden;
    golden.row = static_cast<int>(result.size()) + 1;
    golden.cable = {value.at("EA"), value.at("EI"), value.at("q")};
    golden.x = value.at("xB");
    golden.y = value.at("yB");
    golden.length = value.at("L");
    golden.h = value.at("H");
    golden.v = value.at("V");
    golden.tension_a = value.at("TA");
    golden.angle_a = value.at("a0");
    golden.angle_b = value.at("aL");
    golden.catenary_h = value.at("Hcat");
    golden.catenary_v = value.at("Vcat");
    result.push_back(golden);
  }
  return result;
}

}  // namespace cdpr_kinetostatics
