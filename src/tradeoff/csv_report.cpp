#include <iomanip>
#include <ostream>
#include <sstream>

#include "tradeoff/report.h"

namespace cdpr_kinetostatics {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

void writeRow(const std::string& robot, const Row& row, std::ostream* out) {
  const auto value = [out](const std::optional<double>& number) {
    *out << ",";
    if (number) *out << *number;
  };
  const auto measured = [&](double number) { value(row.solved > 0 ? std::optional<double>(number) : std::nullopt); };
  *out << quoted(robot) << "," << modelName(row.setting.model) << "," << row.setting.tolerance;
  value(row.setting.accuracy);
  *out << "," << problemName(row.problem) << "," << row.trials << "," << row.solved;
  measured(row.median_time);
  measured(row.p99_time);
  value(row.errors.position);
  value(row.errors.rotation);
  value(row.errors.tension);
  value(row.estimated_error);
  *out << "," << (row.solved > 0 ? modelName(row.finest) : "");
  measured(row.iterations);
  measured(row.integrator_steps);
  measured(row.evaluations);
  *out << "," << quoted(row.refusal) << "\n";
}

}  // namespace

void writeCsv(const Provenance& provenance, const std::vector<RobotTrade>& trades, std::ostream* out) {
  *out << "# cpu: " << provenance.cpu << ", cores: " << provenance.cores << "\n# compiler: " << provenance.compiler
       << "\n# build type: " << provenance.build_type << "\n# commit: " << provenance.commit << "\n";
  *out << "robot,model,tolerance,accuracy,problem,trials,solved,median_time,p99_time,position_error,rotation_error,"
          "tension_error,estimated_error,finest_model,iterations,integrator_steps,evaluations,refusal\n";
  *out << std::setprecision(8);
  for (const RobotTrade& trade : trades) {
    for (const Row& row : trade.rows) writeRow(trade.robot.name, row, out);
  }
}

}  // namespace cdpr_kinetostatics
