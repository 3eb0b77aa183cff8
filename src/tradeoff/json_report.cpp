#include <nlohmann/json.hpp>
#include <ostream>

#include "tradeoff/recommendation.h"
#include "tradeoff/report.h"

namespace cdpr_kinetostatics {
namespace {

using nlohmann::ordered_json;

ordered_json valueOf(const std::optional<double>& value) { return value ? ordered_json(*value) : ordered_json(); }

ordered_json rowOf(const Row& row) {
  const bool any = row.solved > 0;
  const auto measured = [any](double value) { return any ? ordered_json(value) : ordered_json(); };
  return {
      {"model", modelName(row.setting.model)},
      {"tolerance", row.setting.tolerance},
      {"accuracy", valueOf(row.setting.accuracy)},
      {"problem", problemName(row.problem)},
      {"trials", row.trials},
      {"solved", row.solved},
      {"refusal", row.refusal},
      {"finest_model", any ? ordered_json(modelName(row.finest)) : ordered_json()},
      {"median_time", measured(row.median_time)},
      {"p99_time", measured(row.p99_time)},
      {"position_error", valueOf(row.errors.position)},
      {"rotation_error", valueOf(row.errors.rotation)},
      {"tension_error", valueOf(row.errors.tension)},
      {"estimated_error", valueOf(row.estimated_error)},
      {"iterations", measured(row.iterations)},
      {"integrator_steps", measured(row.integrator_steps)},
      {"evaluations", measured(row.evaluations)},
  };
}

ordered_json recommendationOf(const RobotTrade& trade, double accuracy) {
  const std::optional<Choice> choice = fastestWithin(choicesOf(trade), accuracy);
  return {
      {"accuracy", accuracy},
      {"model", choice ? ordered_json(modelName(choice->setting.model)) : ordered_json()},
      {"tolerance", choice ? ordered_json(choice->setting.tolerance) : ordered_json()},
      {"error", choice ? ordered_json(choice->error) : ordered_json()},
      {"time", choice ? ordered_json(choice->time) : ordered_json()},
      {"sentence", recommendation(trade, accuracy)},
  };
}

ordered_json robotOf(const RobotTrade& trade) {
  ordered_json rows = ordered_json::array();
  for (const Row& row : trade.rows) rows.push_back(rowOf(row));
  ordered_json recommendations = ordered_json::array();
  for (const double accuracy : kAccuracies) recommendations.push_back(recommendationOf(trade, accuracy));
  return {
      {"name", trade.robot.name},
      {"cables", trade.robot.cables.size()},
      {"span", trade.robot.span()},
      {"kappa_length", trade.layers ? ordered_json{trade.layers->first, trade.layers->second} : ordered_json()},
      {"poses", trade.poses},
      {"rows", rows},
      {"recommendations", recommendations},
  };
}

}  // namespace

void writeJson(const Provenance& provenance, const std::vector<RobotTrade>& trades, std::ostream* out) {
  ordered_json robots = ordered_json::array();
  for (const RobotTrade& trade : trades) robots.push_back(robotOf(trade));
  const ordered_json document = {
      {"machine",
       {{"cpu", provenance.cpu},
        {"cores", provenance.cores},
        {"compiler", provenance.compiler},
        {"build_type", provenance.build_type},
        {"commit", provenance.commit}}},
      {"reference", {{"model", modelName(Model::kBending)}, {"tolerance", kReferenceTolerance}}},
      {"robots", robots},
  };
  *out << document.dump(1) << "\n";
}

}  // namespace cdpr_kinetostatics
