// Stability of an equilibrium of the bending cable from its discrete second variation (docs/theory.md (21)):
//
//     int (lambda^2 beta'^2/e + (e T - eps S^2) beta^2) ds
//
// on hat functions beta, lengths in units of the cable's, forces in those of F0; stretch has been minimised out of it.
// Holding the ends removes the directions that move B.
#pragma once

#include <vector>

namespace cdpr_kinetostatics {

struct VariationPoint {
  double s, alpha, e, tension, shear;
};

class SecondVariation {
 public:
  SecondVariation(double lambda_squared, double eps) : lambda_squared_(lambda_squared), eps_(eps) {}

  // Points in the order of s, both ends included.
  void add(const VariationPoint& point) { points_.push_back(point); }

  // No displacement that leaves both ends in place lowers the energy.
  bool stableWithEndsHeld() const;

 private:
  double lambda_squared_, eps_;
  std::vector<VariationPoint> points_;
};

}  // namespace cdpr_kinetostatics
