// Stability at the extremes: all three problems of cables from everywhere (test/support/extreme_cables.h), cold, judged
// by an independent check, with single shooting beside them; and the cost of problem 2 over kappa L.
//
//   stability_map [--count N] [--quick] [--csv FILE] [--cost FILE] [--timeout SECONDS] [--tolerance T] [--threads N]
//
// --csv: one line per cable; --cost: one line per kappa L. docs/stability.md explains and shows both.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "cable_verdict.h"
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "extreme_cables.h"
#include "timing/timing.h"

using namespace cdpr_kinetostatics;

namespace {

struct Arguments {
  int count = 20000;
  int threads = 2;
  bool quick = false;
  std::string csv, cost;
  JudgeOptions judge;
};

[[noreturn]] void usage() {
  std::cerr << "stability_map [--count N] [--quick] [--csv FILE] [--cost FILE] [--timeout SECONDS] [--tolerance T] "
               "[--threads N]\n";
  std::exit(2);
}

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key == "--quick") {
      a.quick = true;
      a.count = 400;
      continue;
    }
    if (++i == argc) usage();
    const std::string value = argv[i];
    if (key == "--count") {
      a.count = std::atoi(value.c_str());
    } else if (key == "--threads") {
      a.threads = std::atoi(value.c_str());
    } else if (key == "--csv") {
      a.csv = value;
    } else if (key == "--cost") {
      a.cost = value;
    } else if (key == "--timeout") {
      a.judge.timeout = std::atof(value.c_str());
    } else if (key == "--tolerance") {
      a.judge.tolerance = std::atof(value.c_str());
    } else {
      usage();
    }
  }
  if (a.count < 1 || a.threads < 1 || !(a.judge.timeout > 0.0)) usage();
  return a;
}

std::vector<CableVerdict> judgeAll(const std::vector<ExtremeCable>& cables, const Arguments& arguments) {
  std::vector<CableVerdict> verdicts(cables.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < arguments.threads; ++i) {
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < cables.size(); k = next++) {
        JudgeOptions options = arguments.judge;
        options.hinted = (k / 4) % 2 == 1;
        verdicts[k] = judge(cables[k], options);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  return verdicts;
}

void writeCsv(const std::string& file, const std::vector<ExtremeCable>& cables,
              const std::vector<CableVerdict>& verdicts) {
  std::ofstream out(file);
  out << "index,taut,chord,inclination,strain,weight,force,layers,EA,EI,q,L,x,y,H,V,hinted,corner";
  for (const char* name : {"position", "forces", "length", "single"}) {
    for (const char* column : {"outcome", "code", "time", "iterations", "error"}) out << "," << name << "_" << column;
  }
  out << ",message\n" << std::setprecision(17);
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const ExtremeCable& c = cables[i];
    const CableVerdict& v = verdicts[i];
    out << i << "," << c.taut << "," << c.chord << "," << c.inclination << "," << c.strain << "," << c.weight << ","
        << c.force << "," << c.layers << "," << c.cable.axial_stiffness << "," << c.cable.bending_stiffness << ","
        << c.cable.weight << "," << c.length << "," << c.x << "," << c.y << "," << v.h << "," << v.v << "," << v.hinted
        << "," << c.corner();
    std::string message;
    for (const Judged* j : {&v.position, &v.forces, &v.length, &v.single}) {
      out << "," << outcomeName(j->outcome) << "," << static_cast<int>(j->code) << "," << j->time << ","
          << j->iterations << "," << j->error;
      if (message.empty()) message = j->message;
    }
    std::replace(message.begin(), message.end(), ',', ';');
    out << "," << message << "\n";
  }
}

using Pick = std::function<const Judged&(const CableVerdict&)>;

void report(const std::string& title, const std::vector<ExtremeCable>& cables,
            const std::vector<CableVerdict>& verdicts, const Pick& pick, bool corner) {
  std::map<std::string, int> outcomes, refusals;
  std::vector<double> times, errors;
  int asked = 0;
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const Judged& judged = pick(verdicts[i]);
    if (cables[i].corner().empty() == corner || judged.outcome == Outcome::kNotAsked) continue;
    ++asked;
    ++outcomes[outcomeName(judged.outcome)];
    if (judged.outcome == Outcome::kRefused)
      ++refusals[std::to_string(static_cast<int>(judged.code)) + " " + judged.message.substr(0, 70)];
    times.push_back(judged.time);
    if (judged.outcome == Outcome::kSolved) errors.push_back(judged.error);
  }
  if (asked == 0) return;
  std::cout << std::left << std::setw(34) << title << std::right << std::setw(7) << asked;
  for (const char* name : {"solved", "refused", "wrong branch", "inaccurate", "unverified"}) {
    std::cout << std::setw(8) << std::fixed << std::setprecision(3) << 100.0 * outcomes[name] / asked << " %";
  }
  std::cout << std::scientific << std::setprecision(1) << "  error p50 " << quantile(errors, 0.5) << " p99 "
            << quantile(errors, 0.99) << std::fixed << std::setprecision(3) << "  ms p50 " << 1e3 * quantile(times, 0.5)
            << " p99 " << 1e3 * quantile(times, 0.99) << " max " << 1e3 * quantile(times, 1.0) << "\n";
  for (const auto& [reason, count] : refusals) std::cout << "      " << std::setw(6) << count << "  " << reason << "\n";
}

// Problem 2 at 1e-8 of the same cables over kappa L: median over the cables of the best of some repetitions.
struct Cost {
  double layers, taut, slack;  // [s]
};

std::vector<Cost> costOverLayers(bool quick) {
  constexpr double kInclinations[] = {-1.2, -0.7, -0.2, 0.0, 0.3, 0.8, 1.1};
  constexpr double kWeights[] = {0.01, 0.1, 0.5};
  constexpr double kSlackness[] = {1.01, 1.1, 1.5};
  const int repetitions = quick ? 3 : 15;
  std::vector<Cost> costs;
  const auto cost = [&](double layers, bool taut) {
    std::vector<double> times;
    for (const double inclination : kInclinations) {
      for (int i = 0; i < 3; ++i) {
        const double length = taut ? 10.0 / 1.001 : 10.0 * kSlackness[i];
        const double weight = taut ? kWeights[i] * 100.0 : 1.0;
        const double tension = taut ? 100.0 : weight;
        const CableProperties cable{1e5, tension * std::pow(length / layers, 2), weight / length};
        double best = 1e9;
        for (int k = 0; k < repetitions; ++k) {
          const double start = now();
          const CableSolution s =
              findForces(cable, length, 10.0 * std::cos(inclination), 10.0 * std::sin(inclination), {});
          best = std::min(best, now() - start);
          keep(s.horizontal_force);
        }
        times.push_back(best);
      }
    }
    return quantile(times, 0.5);
  };
  for (const double layers : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1e3, 2e3, 5e3, 1e4, 1e5, 1e6}) {
    costs.push_back({layers, cost(layers, true), cost(layers, false)});
  }
  return costs;
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = parse(argc, argv);
  const std::vector<ExtremeCable> cables = extremeCables(arguments.count);
  const double start = now();
  const std::vector<CableVerdict> verdicts = judgeAll(cables, arguments);
  std::cout << cables.size() << " cables in " << std::fixed << std::setprecision(1) << now() - start << " s\n";
  std::cout << std::setw(41) << "asked" << std::setw(10) << "solved" << std::setw(10) << "refused" << std::setw(10)
            << "branch" << std::setw(10) << "inacc." << std::setw(10) << "unverif."
            << "\n";
  for (const bool corner : {false, true}) {
    const std::string where = corner ? ", corners" : "";
    report(
        "1 FIND_POSITION" + where, cables, verdicts, [](const auto& v) -> const Judged& { return v.position; }, corner);
    report(
        "2 FIND_FORCES" + where, cables, verdicts, [](const auto& v) -> const Judged& { return v.forces; }, corner);
    report(
        "3 FIND_LENGTH" + where, cables, verdicts, [](const auto& v) -> const Judged& { return v.length; }, corner);
    report(
        "2 by single shooting" + where, cables, verdicts, [](const auto& v) -> const Judged& { return v.single; },
        corner);
  }
  if (!arguments.csv.empty()) writeCsv(arguments.csv, cables, verdicts);

  std::ofstream out;
  if (!arguments.cost.empty()) out.open(arguments.cost);
  if (out.is_open()) out << "layers,taut,slack\n";
  std::cout << "FIND_FORCES at 1e-8, us:  kappa L      taut     slack\n";
  for (const Cost& c : costOverLayers(arguments.quick)) {
    std::cout << std::setw(33) << std::setprecision(0) << c.layers << std::setw(10) << std::setprecision(1)
              << 1e6 * c.taut << std::setw(10) << 1e6 * c.slack << "\n";
    if (out.is_open()) out << c.layers << "," << c.taut << "," << c.slack << "\n";
  }
  return 0;
}
