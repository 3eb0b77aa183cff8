#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

#include "tradeoff/report.h"
#include "tradeoff/units.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kWidth = 9;
constexpr int kNameWidth = 23;

class Line {
 public:
  Line(const RobotTrade& trade, const Setting& setting) {
    for (const Row& row : trade.rows) {
      if (row.setting.model == setting.model && row.setting.tolerance == setting.tolerance &&
          row.setting.accuracy == setting.accuracy) {
        rows_.push_back(&row);
      }
    }
  }

  std::string time(Problem problem) const {
    const Row* row = find(problem);
    if (row == nullptr || row->solved == 0) return "-";
    return asTime(row->median_time) + (row->solved < row->trials ? "*" : "");
  }
  std::string error(Problem problem) const {
    const Row* row = find(problem);
    return row != nullptr && row->errors.position ? asLength(*row->errors.position) : "-";
  }

 private:
  const Row* find(Problem problem) const {
    for (const Row* row : rows_) {
      if (row->problem == problem) return row;
    }
    return nullptr;
  }

  std::vector<const Row*> rows_;
};

}  // namespace

void writeTable(const RobotTrade& trade, std::ostream* out) {
  std::ostringstream text;
  const auto cell = [&](const std::string& content) { text << std::setw(kWidth) << content; };
  text << std::fixed << std::setprecision(0) << "Robot " << trade.robot.name << ": " << trade.robot.cables.size()
       << " cables, ";
  if (trade.layers) text << "kappa L " << trade.layers->first << " to " << trade.layers->second << ", ";
  text << trade.poses << " poses\n\n";
  text << std::setw(kNameWidth + 6) << "" << std::setw(3 * kWidth) << "forward" << std::setw(2 * kWidth) << "inverse"
       << std::setw(2 * kWidth) << "estimate" << std::setw(2 * kWidth) << "one cable"
       << "\n";
  text << std::setw(kNameWidth) << "model" << std::setw(6) << "tol.";
  for (const char* title : {"cold", "warm", "error", "time", "error", "time", "error", "position", "error"})
    cell(title);
  text << "\n";
  for (const Row& row : trade.rows) {
    if (row.problem != kProblems[0]) continue;
    const Setting& setting = row.setting;
    const Line line(trade, setting);
    std::ostringstream name, tolerance;
    name << modelName(setting.model);
    if (setting.accuracy) name << " " << asLength(*setting.accuracy);
    tolerance << setting.tolerance;
    text << std::setw(kNameWidth) << name.str() << std::setw(6) << tolerance.str();
    cell(line.time(Problem::kForwardCold));
    for (const Problem problem :
         {Problem::kForwardWarm, Problem::kInverse, Problem::kEstimate, Problem::kCablePosition}) {
      cell(line.time(problem));
      cell(line.error(problem));
    }
    text << "\n";
  }
  *out << text.str();
}

}  // namespace cdpr_kinetostatics
