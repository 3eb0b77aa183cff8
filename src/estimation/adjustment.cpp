#include "estimation/adjustment.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "estimation/adjustment_statistics.h"
#include "residuals/platform_measurements.h"
#include "robot/coupled_newton.h"
#include "robot/platform_stability.h"
#include "robot/platform_statics.h"
#include "robot/residual_blocks.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

// A warm adjustment takes 2 to 5 iterations, a cold one some 20.
constexpr int kMaxIterations = 100;

// The least-squares problem is dimensionless and nearly linear: the first step is hardly damped, and the sum of squares
// has settled when it changes by less than this share, or the unknowns by less than that.
constexpr double kInitialTrustRegion = 1e8;
constexpr double kSettledSquares = 1e-14;
constexpr double kSettledUnknowns = 1e-10;

// Ceres gives up after so many steps in a row that its linear model does not allow, and logs an error then, even if it
// is told to be silent. It is stopped one step before: the report says how it ended.
constexpr int kMostInvalidSteps = 5;

class StopQuietly : public ceres::IterationCallback {
 public:
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& iteration) override {
    invalid_ = iteration.step_is_valid ? 0 : invalid_ + 1;
    return invalid_ < kMostInvalidSteps - 1 ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
  }

 private:
  int invalid_ = 0;
};

// The clock's limit for Ceres, which counts seconds as a double [s].
constexpr double kLongestTime = 1e6;

std::unique_ptr<PlatformMeasurements> measurementsBlock(const RobotDescription& robot, const EstimatorOptions& options,
                                                        const CableMeasurements& measurements,
                                                        const Selection& selection, const std::vector<Model>& rungs,
                                                        const RobotForces& start, Clock::time_point deadline) {
  using Measured = PlatformMeasurements::Measured;
  std::vector<PlatformMeasurements::Cable> cables;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CableDescription& cable = robot.cables[i];
    SaggingCable shape(cable.properties, rungs[i], options.tolerance);
    shape.start(start.lengths[i], start.forces[i]);
    cables.push_back({cable.anchor, cable.attachment, std::move(shape), {}, {}});
    if (selection.lengths[i]) cables.back().length = Measured{*measurements.lengths[i], options.length_stddev};
    if (selection.tensions[i]) cables.back().tension = Measured{*measurements.tensions[i], options.tension_stddev};
  }
  const Wrench load_weight = (selection.load.cast<double>() / options.load_stddev.array()).matrix();
  return std::make_unique<PlatformMeasurements>(platformOf(robot, Wrench::Zero()), cables, load_weight,
                                                SolveLimits{options.tolerance, deadline});
}

// The selected measurements, in the order of the block's residuals.
std::vector<Observation> observationsOf(const RobotDescription& robot, const Selection& selection) {
  std::vector<Observation> observations;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    if (selection.lengths[i]) observations.push_back({Observation::Kind::kLength, i});
  }
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    if (selection.tensions[i]) observations.push_back({Observation::Kind::kTension, i});
  }
  for (std::size_t k = 0; selection.load.any() && k < static_cast<std::size_t>(robot.freedoms()); ++k) {
    observations.push_back({Observation::Kind::kLoad, k});
  }
  return observations;
}

Eigen::MatrixXd dense(const ceres::CRSMatrix& sparse) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(sparse.num_rows, sparse.num_cols);
  for (int row = 0; row < sparse.num_rows; ++row) {
    for (int k = sparse.rows[row]; k < sparse.rows[row + 1]; ++k) matrix(row, sparse.cols[k]) = sparse.values[k];
  }
  return matrix;
}

// The unknowns of an adjustment, and the Ceres problem that they are parameters of.
class Adjustment {
 public:
  Adjustment(const RobotDescription& robot, std::unique_ptr<PlatformMeasurements> block, const RobotForces& start)
      : robot_(robot),
        block_(block.get()),
        position_(start.pose.position),
        orientation_(start.pose.orientation),
        rigid_(robot.type == PlatformType::kRigidBody) {
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      const CablePlane plane = cablePlane(robot.cables[i], start.pose);
      densities_.push_back(start.forces[i].horizontal / distanceBeside(plane.x, start.lengths[i]));
    }
    problem_.AddResidualBlock(block.release(), nullptr, position_.data(), orientation_.coeffs().data(),
                              densities_.data());
    if (rigid_) {
      problem_.SetManifold(orientation_.coeffs().data(), new ceres::EigenQuaternionManifold);
    } else {
      problem_.SetParameterBlockConstant(orientation_.coeffs().data());
    }
  }

  // Ceres would log an error where the block cannot be evaluated at the start, even if it is told to be silent; the
  // report says it instead.
  Status solve(Clock::time_point deadline, int* iterations) {
    const std::vector<const double*> start = {position_.data(), orientation_.coeffs().data(), densities_.data()};
    std::vector<double> residuals(static_cast<std::size_t>(block_->num_residuals()));
    if (!block_->Evaluate(start.data(), residuals.data(), nullptr)) {
      return {Code::kNotConverged,
              "the cables cannot be closed where the search for the pose starts: check the robot's description and "
              "units"};
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.max_num_iterations = kMaxIterations;
    options.initial_trust_region_radius = kInitialTrustRegion;
    options.function_tolerance = kSettledSquares;
    options.gradient_tolerance = 0.0;
    options.parameter_tolerance = kSettledUnknowns;
    options.max_solver_time_in_seconds =
        std::clamp(std::chrono::duration<double>(deadline - Clock::now()).count(), 0.0, kLongestTime);
    options.max_num_consecutive_invalid_steps = kMostInvalidSteps;
    StopQuietly stop_quietly;
    options.callbacks = {&stop_quietly};
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    *iterations = static_cast<int>(summary.iterations.size());
    if (summary.IsSolutionUsable() && summary.termination_type != ceres::NO_CONVERGENCE) return {Code::kConverged, ""};
    return {Code::kNotConverged,
            "no pose explains these lengths and tensions: check the robot's description and units"};
  }

  // Unknowns, residuals and Jacobian at the solution; observations in the order of the residuals. False if the block
  // cannot be evaluated there.
  bool read(std::vector<Observation> observations, Adjusted* adjusted) {
    ceres::Problem::EvaluateOptions at;
    at.parameter_blocks = {position_.data()};
    if (rigid_) at.parameter_blocks.push_back(orientation_.coeffs().data());
    at.parameter_blocks.push_back(densities_.data());
    std::vector<double> residuals;
    ceres::CRSMatrix sparse;
    if (!problem_.Evaluate(at, nullptr, &residuals, nullptr, &sparse)) return false;
    adjusted->unknowns.pose = {position_, orientation_.normalized()};
    for (const ClosedCable& closed : block_->cables()) {
      const SaggingCable& cable = closed.cable();
      adjusted->unknowns.lengths.push_back(cable.length());
      adjusted->unknowns.forces.push_back({cable.horizontalForce(), cable.verticalForceA()});
      adjusted->cables.push_back(cable);
    }
    adjusted->observations = std::move(observations);
    for (std::size_t k = 0; k < residuals.size(); ++k) {
      adjusted->observations[k].residual = residuals[k];
      adjusted->observations[k].row = static_cast<Eigen::Index>(k);
    }
    adjusted->jacobian = dense(sparse);
    if (rigid_) adjusted->jacobian.middleCols<3>(3) *= 0.5;  // the manifold's tangent is half the rotation vector
    return true;
  }

  // Statistics and stability, after read().
  void judge(Adjusted* adjusted) const {
    const Eigen::Index freedoms = robot_.freedoms();
    const LoadBalance balance = block_->loadBalance();
    Eigen::MatrixXd load(freedoms, adjusted->jacobian.cols());
    load << balance.by_pose.topLeftCorner(freedoms, freedoms), balance.by_density.topRows(freedoms);
    analyse(load, adjusted);
    adjusted->stable = platformStability(robot_, block_->stiffness(balance)).kind != Stability::kUnstable;
  }

 private:
  const RobotDescription& robot_;
  const PlatformMeasurements* block_;  // the problem's own
  Eigen::Vector3d position_;
  Eigen::Quaterniond orientation_;
  std::vector<double> densities_;
  const bool rigid_;
  ceres::Problem problem_;
};

}  // namespace

Adjusted adjust(const RobotDescription& robot, const EstimatorOptions& options, const CableMeasurements& measurements,
                const Selection& selection, const std::vector<Model>& rungs, const RobotForces& start,
                Clock::time_point deadline) {
  Adjusted adjusted;
  if (Clock::now() >= deadline) {
    adjusted.status = {Code::kTimedOut, "the time allowed ran out before the pose was estimated"};
    return adjusted;
  }
  Adjustment adjustment(robot, measurementsBlock(robot, options, measurements, selection, rungs, start, deadline),
                        start);
  adjusted.status = adjustment.solve(deadline, &adjusted.iterations);
  if (adjusted.status.ok() && !adjustment.read(observationsOf(robot, selection), &adjusted)) {
    adjusted.status = {
        Code::kNotConverged,
        "these measurements lead to a pose at which a cable cannot be evaluated: check lengths and tensions"};
  }
  if (adjusted.status.ok()) {
    adjustment.judge(&adjusted);
  } else if (SolveLimits::isPast(deadline)) {
    adjusted.status = {Code::kTimedOut, "the time allowed ran out while the pose was estimated"};
  }
  return adjusted;
}

Adjusted evaluate(const RobotDescription& robot, const EstimatorOptions& options, const CableMeasurements& measurements,
                  const Selection& selection, const std::vector<Model>& rungs, const RobotForces& at,
                  Clock::time_point deadline) {
  Adjusted adjusted;
  Adjustment adjustment(robot, measurementsBlock(robot, options, measurements, selection, rungs, at, deadline), at);
  const bool evaluated = adjustment.read(observationsOf(robot, selection), &adjusted);
  adjusted.status.code = evaluated ? Code::kConverged : Code::kNotConverged;
  return adjusted;
}

}  // namespace cdpr_kinetostatics
