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

// Each line below the first, which has the names.
std::vector<std::map<std::string, std::string>> linesOf(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) throw std::runtime_error("cannot read " + file);
  const std::vector<std::string> names = fields(line);
  std::vector<std::map<std::string, std::string>> result;
  while (std::getline(in, line)) {
    const std::vector<std::string> values = fields(line);
    if (values.size() != names.size()) throw std::runtime_error("a short line in " + file);
    std::map<std::string, std::string>& value = result.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) value[names[i]] = values[i];
  }
  return result;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const GoldenCable& golden) {
  return out << "row " << golden.row << " of cables.csv";
}

std::ostream& operator<<(std::ostream& out, const GoldenPulleyCable& golden) {
  return out << "row " << golden.row << " of pulley_cables.csv";
}

std::vector<GoldenCable> goldenCables(const std::string& directory) {
  std::vector<GoldenCable> result;
  for (const auto& line : linesOf(directory + "/cables.csv")) {
    const auto value = [&](const char* name) { return std::stod(line.at(name)); };
    GoldenCable golden;
    golden.row = static_cast<int>(result.size()) + 1;
    golden.cable = {value("EA"), value("EI"), value("q")};
    golden.x = value("xB");
    golden.y = value("yB");
    golden.length = value("L");
    golden.h = value("H");
    golden.v = value("V");
    golden.tension_a = value("TA");
    golden.angle_a = value("a0");
    golden.angle_b = value("aL");
    golden.catenary_h = value("Hcat");
    golden.catenary_v = value("Vcat");
    result.push_back(golden);
  }
  return result;
}

std::vector<GoldenPulleyCable> goldenPulleyCables(const std::string& directory) {
  std::vector<GoldenPulleyCable> result;
  for (const auto& line : linesOf(directory + "/pulley_cables.csv")) {
    const auto value = [&](const char* name) { return std::stod(line.at(name)); };
    const RopeFrom from = line.at("from_below") == "True" ? RopeFrom::kBelow : RopeFrom::kAbove;
    GoldenPulleyCable golden;
    golden.row = static_cast<int>(result.size()) + 1;
    golden.cable = {value("EA"), value("EI"), value("q"), {value("radius"), from}};
    golden.x = value("x");
    golden.y = value("y");
    golden.length = value("length");
    golden.h = value("H");
    golden.v = value("V");
    golden.tension_a = value("T");
    golden.angle_a = value("angle_a");
    golden.angle_b = value("angle_b");
    golden.wrap = value("wrap");
    golden.free_length = value("free_length");
    golden.max_moment = value("max_moment");
    result.push_back(golden);
  }
  return result;
}

}  // namespace cdpr_kinetostatics
