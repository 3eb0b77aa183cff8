#include "support/ceres_yardstick.h"

#include <ceres/dynamic_cost_function.h>
#include <ceres/solver.h>

#include <algorithm>
#include <vector>

#include "robot_cases.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kPose = 6;
constexpr int kPair = 2;

}  // namespace

class CeresYardstick::Copied : public ceres::DynamicCostFunction {
 public:
  explicit Copied(int cables) {
    Dice dice(5);
    AddParameterBlock(kPose);
    for (int i = 0; i < cables; ++i) AddParameterBlock(kPair);
    const int n = kPose + kPair * cables;
    SetNumResiduals(n);
    for (const int size : parameter_block_sizes()) {
      std::vector<double> block(static_cast<std::size_t>(n) * size);
      for (double& value : block) value = dice.uniform(-1.0, 1.0);
      jacobian_.push_back(std::move(block));
    }
    residual_.resize(n);
    for (double& value : residual_) value = dice.uniform(-1.0, 1.0);
  }

  void restart() { share_ = 1.0; }

  // Every evaluation finds the residuals that Newton's method would: a thousandth of the ones before.
  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override {
    if (jacobians == nullptr) share_ *= 1e-3;  // a new point: Jacobians are asked for where a step has succeeded
    for (std::size_t i = 0; i < residual_.size(); ++i) residuals[i] = share_ * residual_[i];
    if (jacobians == nullptr) return true;
    for (std::size_t i = 0; i < jacobian_.size(); ++i) {
      if (jacobians[i] != nullptr) std::copy(jacobian_[i].begin(), jacobian_[i].end(), jacobians[i]);
    }
    return true;
  }

 private:
  std::vector<double> residual_;
  std::vector<std::vector<double>> jacobian_;
  mutable double share_ = 1.0;
};

CeresYardstick::CeresYardstick(int cables, int iterations)
    : iterations_(iterations), unknowns_(kPose + kPair * cables), cost_(new Copied(cables)) {
  std::vector<double*> blocks;
  double* next = unknowns_.data();
  for (const int size : cost_->parameter_block_sizes()) {
    blocks.push_back(next);
    next += size;
  }
  problem_.AddResidualBlock(cost_, nullptr, blocks);
}

CeresYardstick::~CeresYardstick() = default;

int CeresYardstick::solve() {
  std::fill(unknowns_.begin(), unknowns_.end(), 0.0);
  cost_->restart();
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = iterations_;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0.0;
  options.initial_trust_region_radius = 1e8;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem_, &summary);
  return static_cast<int>(summary.iterations.size()) - 1;
}

}  // namespace cdpr_kinetostatics
