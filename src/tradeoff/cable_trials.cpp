// The three problems of one cable.
#include <cmath>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "tradeoff/trial.h"

namespace cdpr_kinetostatics {
namespace {

class CableTrial : public Trial {
 public:
  CableTrial(Problem problem, const CableProperties& cable, const CableSolution& reference, const Setting& setting)
      : problem_(problem), cable_(cable), reference_(reference) {
    options_.model = setting.model;
    options_.tolerance = setting.tolerance;
    if (setting.accuracy) options_.accuracy = *setting.accuracy;
  }

  void solve() override {
    const CableSolution& r = reference_;
    if (problem_ == Problem::kCablePosition) {
      solution_ = findPosition(cable_, r.length, r.horizontal_force, r.vertical_force_a, options_);
    } else if (problem_ == Problem::kCableForces) {
      solution_ = findForces(cable_, r.length, r.x, r.y, options_);
    } else {
      solution_ = findLength(cable_, r.x, r.y, r.tension_a, r.length, options_);
    }
  }

  Outcome outcome() const override {
    Outcome outcome;
    outcome.status = solution_.status;
    outcome.finest = solution_.model;
    outcome.iterations = solution_.iterations;
    outcome.integrator_steps = solution_.integrator_steps;
    outcome.evaluations = solution_.evaluations;
    if (!outcome.status.ok()) return outcome;
    outcome.estimated_error = solution_.estimated_error;
    if (problem_ == Problem::kCablePosition) {
      outcome.errors.position = std::hypot(solution_.x - reference_.x, solution_.y - reference_.y);
    } else if (problem_ == Problem::kCableForces) {
      outcome.errors.tension = std::abs(solution_.tension_a - reference_.tension_a);
    } else {
      outcome.errors.position = std::abs(solution_.length - reference_.length);
    }
    return outcome;
  }

 private:
  const Problem problem_;
  const CableProperties& cable_;
  const CableSolution& reference_;
  CableSolverOptions options_;
  CableSolution solution_;
};

}  // namespace

std::unique_ptr<Trial> makeCableTrial(Problem problem, const CableProperties& cable, const CableSolution& reference,
                                      const Setting& setting) {
  return std::make_unique<CableTrial>(problem, cable, reference, setting);
}

}  // namespace cdpr_kinetostatics
