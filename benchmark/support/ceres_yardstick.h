// What Ceres itself costs on a problem of the robot's size: one solve whose residuals and Jacobian cost nothing.
#pragma once

#include <ceres/problem.h>

#include <vector>

namespace cdpr_kinetostatics {

// One dense block of as many residuals as unknowns: a pose (6) and a pair of forces for each cable. Evaluations
// copy numbers that were made before, such that every step succeeds and so many iterations are taken.
class CeresYardstick {
 public:
  CeresYardstick(int cables, int iterations);
  ~CeresYardstick();
  CeresYardstick(const CeresYardstick&) = delete;
  CeresYardstick& operator=(const CeresYardstick&) = delete;

  // ceres::Solve with DENSE_QR; returns the iterations that it took.
  int solve();

 private:
  class Copied;
  const int iterations_;
  std::vector<double> unknowns_;
  Copied* cost_;  // owned by problem_
  ceres::Problem problem_;
};

}  // namespace cdpr_kinetostatics
