#include "estimation/plausibility.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

// Most cables longer than so many times the robot's reach are not the robot's. Inches for metres make 39 times, and a
// cable in use has at least a third of the reach.
constexpr double kTooLong = 12.0;

// Most pairs of cables miss their anchors' distance by this factor, which no rope stretches, and most cables have less
// than this share of their lengths at home: two cables are one pair, in which a single fault must not decide.
constexpr double kTooShort = 1.5;
constexpr double kShare = 0.5;

// Tensions that sum up to less than this share of the weight, that of the cables included, carry no platform, even if
// some cells are dead.
constexpr double kTooWeak = 0.2;

// Most tensions above so many times the largest one allowed.
constexpr double kTooStrong = 20.0;

// A unit is named if the lengths' factor is within this factor of the unit's: poses of one robot differ by less.
constexpr double kNearUnit = 3.0;

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

std::string lengthUnit(double factor) {
  struct Unit {
    const char* name;
    double in_metres;
  };
  constexpr Unit kUnits[] = {
      {"millimetres", 1e-3}, {"inches", 0.0254}, {"centimetres", 1e-2}, {"feet", 0.3048}, {"kilometres", 1e3}};
  const auto distance = [&](const Unit& unit) { return std::abs(std::log(factor * unit.in_metres)); };
  const Unit* nearest = std::min_element(std::begin(kUnits), std::end(kUnits),
                                         [&](const Unit& a, const Unit& b) { return distance(a) < distance(b); });
  return distance(*nearest) < std::log(kNearUnit) ? std::string(" Are they in ") + nearest->name + "?" : "";
}

Status checkLengths(const RobotDescription& robot, const CableMeasurements& measurements) {
  std::vector<double> lengths, chords, shares, pairs;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    if (!measurements.lengths[i]) continue;
    lengths.push_back(*measurements.lengths[i]);
    chords.push_back(anchorToAttachment(robot.cables[i], robot.home).norm());
    shares.push_back(lengths.back() / chords.back());
    for (std::size_t k = 0; k < i; ++k) {
      if (!measurements.lengths[k]) continue;
      const double anchors = (robot.cables[i].anchor - robot.cables[k].anchor).norm();
      const double attachments = (robot.cables[i].attachment - robot.cables[k].attachment).norm();
      pairs.push_back((anchors - attachments) / (*measurements.lengths[i] + *measurements.lengths[k]));
    }
  }
  if (lengths.empty()) return {Code::kConverged, ""};
  const double typical = median(lengths);
  const double reach = std::max(robot.span(), *std::max_element(chords.begin(), chords.end())) + robot.platformRadius();
  const bool too_long = typical > kTooLong * reach;
  const bool too_short = !pairs.empty() && median(pairs) > kTooShort && median(shares) < kShare;
  if (!too_long && !too_short) return {Code::kConverged, ""};
  std::ostringstream text;
  text << "the lengths cannot be this robot's in metres: most cables measure about " << typical << " m, ";
  if (too_long) {
    text << "though the robot reaches " << reach << " m only.";
  } else {
    text << "too short to reach the platform from anchors so far apart.";
  }
  text << lengthUnit(typical / median(chords));
  return {Code::kInvalidInput, text.str()};
}

// The anchors hold up the platform and the cables.
Status checkCarries(const RobotDescription& robot, const EstimatorOptions& options,
                    const CableMeasurements& measurements) {
  double sum = 0.0;
  double by_metre = 0.0;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    if (!measurements.tensions[i] || !measurements.lengths[i]) return {Code::kConverged, ""};
    sum += std::abs(*measurements.tensions[i]);
    by_metre += robot.cables[i].properties.weight;
    lengths.push_back(*measurements.lengths[i]);
  }
  const double deviations = options.tension_stddev * static_cast<double>(robot.cables.size());
  const double weight = robot.weight() + by_metre * median(lengths);
  if (!options.known_load || sum + deviations >= kTooWeak * weight) return {Code::kConverged, ""};
  std::ostringstream text;
  text << "the tensions cannot be this robot's in newtons: they sum up to " << sum << " N, and the platform weighs "
       << robot.weight() << " N.";
  // A taut robot's tensions sum up to one to thirty times the weight.
  const double kilo = 1e3 * sum / weight;
  if (kilo > 0.3 && kilo < 100.0) text << " Are they in kilonewtons?";
  return {Code::kInvalidInput, text.str()};
}

Status checkAllowed(const RobotDescription& robot, const CableMeasurements& measurements) {
  std::vector<double> shares, tensions;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    if (!measurements.tensions[i]) continue;
    tensions.push_back(*measurements.tensions[i]);
    shares.push_back(*measurements.tensions[i] / robot.cables[i].tension_max);
  }
  if (shares.empty() || !(median(shares) > kTooStrong)) return {Code::kConverged, ""};
  std::ostringstream text;
  text << "the tensions cannot be this robot's in newtons: most are about " << median(tensions) << " N, "
       << median(shares) << " times what the cables may carry. Are they in millinewtons?";
  return {Code::kInvalidInput, text.str()};
}

}  // namespace

Status checkPlausible(const RobotDescription& robot, const EstimatorOptions& options,
                      const CableMeasurements& measurements) {
  Status status = checkLengths(robot, measurements);
  if (status.ok()) status = checkCarries(robot, options, measurements);
  if (status.ok()) status = checkAllowed(robot, measurements);
  return status;
}

}  // namespace cdpr_kinetostatics
