// A shot integrated by SUNDIALS' CVODES with forward sensitivities. Its memory is kept from shot to shot.
#pragma once

#include <memory>

#include "cable/shot.h"

namespace cdpr_kinetostatics {

// What CVODES leaves to its user.
struct CvodesSettings {
  bool bdf = false;            // backward differentiation formulas, else Adams
  bool newton = false;         // corrector: Newton's method with the analytic Jacobian, else fixed-point iteration
  bool staggered = false;      // sensitivities are corrected after the state, else together with it
  bool error_control = false;  // errors of sensitivities count in the choice of steps
};

class CvodesShot {
 public:
  explicit CvodesShot(const CvodesSettings& settings);
  ~CvodesShot();

  // tolerance: relative and absolute. False where CVODES gives up.
  bool shoot(const ShotParameters& parameters, double t0, double t1, const ShotState& start, double tolerance,
             Shot* shot);

  // Of the right-hand side, in all shots so far.
  long evaluations() const;

 private:
  class Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace cdpr_kinetostatics
