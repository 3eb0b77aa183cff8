// A trial is one problem that is solved again and again in one way: its solves are timed, and its answer is compared
// with the reference.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/model.h"
#include "cdpr_kinetostatics/cable/report.h"
#include "tradeoff/scenario.h"

namespace cdpr_kinetostatics {

// How a problem is solved.
struct Setting {
  Model model = Model::kBending;
  double tolerance = 1e-8;
  std::optional<double> accuracy;  // AUTO: modelling error accepted at the platform [m]
};

enum class Problem {
  kForwardCold,    // seeded at home
  kForwardWarm,    // seeded 10 mm away
  kInverse,        //
  kEstimate,       // lengths and tensions to pose, after an estimate 10 mm away
  kCablePosition,  // one cable: forces to end point
  kCableForces,    // one cable: end points to forces
  kCableLength,    // one cable: tension to length
};
constexpr Problem kProblems[] = {Problem::kForwardCold, Problem::kForwardWarm,   Problem::kInverse,
                                 Problem::kEstimate,    Problem::kCablePosition, Problem::kCableForces,
                                 Problem::kCableLength};

const char* problemName(Problem problem);

// Distance from the reference; empty where the problem has no such quantity, or it could not be found out.
//   forward    the reference's lengths: pose and tensions
//   inverse    pose that the lengths found lead to, against the one asked for; tensions there, against those promised
//   estimate   the reference's lengths and tensions as measurements: pose and tensions
//   one cable  end point, or length, or tension
struct Errors {
  std::optional<double> position;  // [m]
  std::optional<double> rotation;  // [rad]
  std::optional<double> tension;   // largest of all cables [N]
};

struct Outcome {
  Status status;
  Errors errors;
  Model finest = Model::kDefault;         // finest rung used
  std::optional<double> estimated_error;  // the solver's own estimate of the modelling error, if it trusts it [m]
  int iterations = 0;
  int integrator_steps = 0;
  int evaluations = 0;
};

class Trial {
 public:
  virtual ~Trial() = default;
  // What comes before each solve and is not timed.
  virtual void prepare() {}
  virtual void solve() = 0;
  // Of the last solve.
  virtual Outcome outcome() const = 0;
};

// The problem on every scenario; on every cable of every scenario for the problems of one cable. Robot and scenarios
// must outlive the trials.
std::vector<std::unique_ptr<Trial>> trialsOf(Problem problem, const RobotDescription& robot,
                                             const std::vector<Scenario>& scenarios, const Setting& setting);

// Behind trialsOf().
std::unique_ptr<Trial> makeRobotTrial(Problem problem, const RobotDescription& robot, const Scenario& scenario,
                                      const Setting& setting);
std::unique_ptr<Trial> makeCableTrial(Problem problem, const CableProperties& cable, const CableSolution& reference,
                                      const Setting& setting);

}  // namespace cdpr_kinetostatics
