#include "estimation/rival_faults.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "estimation/adjustment_statistics.h"
#include "estimation/fault_search.h"

namespace cdpr_kinetostatics {
namespace {

// A rival may have so much larger a sum of squares, four standard deviations squared: where it is the truth, noise
// makes the difference larger in one of 30000 messages. The pose of a rival can be a hundred deviations away, so a
// truth that is not among the rivals must be rarer than that squared.
constexpr double kAsLikely = 16.0;

// What an exchange of faults does to the sum of squares is foreseen to first order. A rival that is foreseen to lower
// it by less than this share of what the fault found does is none.
constexpr double kForeseen = 0.5;

// A residual of more standard deviations than this may be that of a fault: of 22 measurements without one, one is so
// large in 6 % of messages.
constexpr double kUnproven = 3.0;

std::vector<Observation> listed(const Selection& selection) {
  std::vector<Observation> observations;
  for (std::size_t i = 0; i < selection.lengths.size(); ++i) {
    if (selection.lengths[i]) observations.push_back({Observation::Kind::kLength, i});
    if (selection.tensions[i]) observations.push_back({Observation::Kind::kTension, i});
  }
  for (std::size_t k = 0; k < 6; ++k) {
    if (selection.load(static_cast<Eigen::Index>(k))) observations.push_back({Observation::Kind::kLoad, k});
  }
  return observations;
}

// By how much the sum of squares falls without each observation, to first order about a state that explains the others
// (docs/theory.md section 5).
std::vector<LeftOut> foreseen(const Adjusted& at) {
  const Eigen::MatrixXd range = explainable(at.jacobian);
  Eigen::VectorXd residuals(range.rows());
  for (const Observation& o : at.observations) residuals(o.row) = o.residual;
  residuals -= range * (range.transpose() * residuals);
  std::vector<LeftOut> gains;
  for (const Observation& o : at.observations) {
    const double redundancy = 1.0 - range.row(o.row).squaredNorm();
    if (redundancy >= kTestable) gains.push_back({o, std::pow(residuals(o.row), 2) / redundancy, 1.0});
  }
  return gains;
}

// One of the faults taken back, and what may be at fault in its place.
struct Exchange {
  Selection with;
  LeftOut fault;
  std::vector<LeftOut> suspects;
};

Exchange exchangeOf(const MeasuredRobot& measured, const Candidate& best, const Observation& fault) {
  Exchange exchange{best.selection, {fault}, {}};
  use(fault, true, &exchange.with);
  const Adjusted at = evaluate(measured.robot, measured.options, measured.measurements, exchange.with, measured.rungs,
                               best.adjusted.unknowns, measured.deadline);
  if (!at.status.ok()) return exchange;
  const std::vector<LeftOut> gains = foreseen(at);
  for (const LeftOut& gain : gains) {
    if (isSame(gain.observation, fault)) exchange.fault = gain;
  }
  const double needed = std::max(kForeseen * (exchange.fault.gain - kAsLikely), 0.0);
  for (const LeftOut& gain : gains) {
    if (gain.gain > needed && !isSame(gain.observation, fault)) exchange.suspects.push_back(gain);
  }
  return exchange;
}

bool isKnown(const std::vector<Candidate>& rivals, const Selection& selection) {
  return std::any_of(rivals.begin(), rivals.end(),
                     [&](const Candidate& rival) { return isSame(rival.selection, selection); });
}

// Adds those with one of best's faults exchanged, as far as time allows. Best gets what its faults would bring.
void addExchanges(const MeasuredRobot& measured, Candidate* best, std::vector<Candidate>* rivals) {
  best->left_out.clear();
  for (const Observation& fault : listed(leftOut(measured, *best))) {
    if (std::chrono::steady_clock::now() >= measured.deadline) return;
    const Exchange exchange = exchangeOf(measured, *best, fault);
    best->left_out.push_back(exchange.fault);
    for (const LeftOut& suspect : exchange.suspects) {
      Selection without = exchange.with;
      use(suspect.observation, false, &without);
      if (isKnown(*rivals, without)) continue;
      Candidate rival = adjust(measured, best->adjusted.unknowns, without);
      if (rival.adjusted.status.ok() && rival.adjusted.stable) rivals->push_back(std::move(rival));
    }
  }
}

// Payloads come and go every day, sensors fail seldom: of answers that the data cannot tell apart, one without the
// known load goes before those that keep it.
bool isLikelier(const MeasuredRobot& measured, const Candidate& a, const Candidate& b) {
  const bool payload_a = (a.selection.load != measured.available.load).any();
  const bool payload_b = (b.selection.load != measured.available.load).any();
  if (payload_a == payload_b) return isBetter(measured, a, b);
  const double gain = b.adjusted.weighted_squares - a.adjusted.weighted_squares;
  return payload_a ? gain > -kAsLikely : gain > kAsLikely;
}

bool takeBetter(const MeasuredRobot& measured, Candidate* best, std::vector<Candidate>* rivals) {
  bool taken = false;
  for (Candidate& rival : *rivals) {
    if (!isLikelier(measured, rival, *best)) continue;
    std::swap(rival, *best);
    taken = true;
  }
  return taken;
}

}  // namespace

// A rival that turns out better takes the place of the best one, and gets rivals of its own. This ends, for each one is
// better than the one before.
std::vector<Candidate> rivalsOf(const MeasuredRobot& measured, Candidate* best) {
  std::vector<Candidate> rivals;
  do {
    addExchanges(measured, best, &rivals);
  } while (takeBetter(measured, best, &rivals));
  double least = best->adjusted.weighted_squares;
  for (const Candidate& rival : rivals) least = std::min(least, rival.adjusted.weighted_squares);
  const double most = least + kAsLikely;
  const auto unlikely = [&](const Candidate& rival) { return rival.adjusted.weighted_squares > most; };
  rivals.erase(std::remove_if(rivals.begin(), rivals.end(), unlikely), rivals.end());
  return rivals;
}

std::vector<Candidate> unprovenFaults(const MeasuredRobot& measured, const Candidate& best) {
  std::vector<Candidate> unproven;
  for (const Observation& suspect : best.adjusted.observations) {
    if (statistic(suspect) < kUnproven) continue;
    Selection without = best.selection;
    use(suspect, false, &without);
    Candidate without_it = adjust(measured, best.adjusted.unknowns, without);
    if (without_it.adjusted.status.ok() && without_it.adjusted.stable) unproven.push_back(std::move(without_it));
  }
  return unproven;
}

}  // namespace cdpr_kinetostatics
