#include "cdpr_kinetostatics/estimation/pose_estimator.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "cdpr_kinetostatics/estimation/adjustment.h"
#include "cdpr_kinetostatics/robot/platform_statics.h"
#include "cdpr_kinetostatics/robot/solution_assembly.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

// An error that shows in its own residual by less than this share cannot be told from others.
constexpr double kTestable = 0.01;

// So many of the worst measurements are left out in turn to find the faulty one.
constexpr std::size_t kSuspects = 16;

// A measurement that jumps this many times farther than most others since the last estimate is not trusted at first.
constexpr double kJump = 10.0;

// Directions with a standard deviation beyond this share of the robot's span are not fixed by the data.
constexpr double kUnobservable = 1.0;

struct Candidate {
  Adjusted adjusted;
  Selection selection;
};

int count(const std::vector<bool>& flags) { return static_cast<int>(std::count(flags.begin(), flags.end(), true)); }

// Observations whose residual exceeds the threshold in units of its own standard deviation, worst first.
std::vector<Observation> suspects(const std::vector<Observation>& observations, double threshold) {
  const auto statistic = [](const Observation& o) { return std::abs(o.residual) / std::sqrt(o.redundancy); };
  std::vector<Observation> found;
  for (const Observation& o : observations) {
    if (o.redundancy >= kTestable && statistic(o) > threshold) found.push_back(o);
  }
  std::sort(found.begin(), found.end(),
            [&](const Observation& l, const Observation& r) { return statistic(l) > statistic(r); });
  return found;
}

void leaveOut(const Observation& observation, Selection* selection) {
  switch (observation.kind) {
    case Observation::Kind::kLength:
      selection->lengths[observation.index] = false;
      break;
    case Observation::Kind::kTension:
      selection->tensions[observation.index] = false;
      break;
    case Observation::Kind::kLoad:
      selection->load(static_cast<Eigen::Index>(observation.index)) = false;
      break;
  }
}

Status checkMeasurements(const RobotDescription& robot, const CableMeasurements& measurements) {
  const std::size_t n = robot.cables.size();
  std::ostringstream text;
  if (measurements.lengths.size() != n || measurements.tensions.size() != n) {
    text << measurements.lengths.size() << " lengths and " << measurements.tensions.size() << " tensions for " << n
         << " cables";
    return {Code::kInvalidInput, text.str()};
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double length = measurements.lengths[i].value_or(1.0);
    const double tension = measurements.tensions[i].value_or(1.0);
    if (length > 0.0 && length <= 1e6 && tension >= 0.0 && tension <= 1e12) continue;
    text << "cable '" << robot.cables[i].name << "': length " << length << " m must be positive, tension " << tension
         << " N zero or positive";
    return {Code::kInvalidInput, text.str()};
  }
  return {Code::kConverged, ""};
}

class Update {
 public:
  Update(const RobotDescription& robot, const EstimatorOptions& options, const CableMeasurements& measurements)
      : robot_(robot),
        options_(options),
        measurements_(measurements),
        deadline_(Clock::now() + std::chrono::duration_cast<Clock::duration>(options.timeout)) {
    for (std::size_t i = 0; i < robot.cables.size(); ++i) {
      available_.lengths.push_back(measurements.lengths[i].has_value());
      available_.tensions.push_back(measurements.tensions[i].has_value());
    }
    // Lengths alone fix no pose: the load then stands in for the tensions.
    const bool load = options.known_load || count(available_.tensions) == 0;
    for (int k = 0; k < robot.freedoms(); ++k) available_.load(k) = load;
  }

  const Selection& available() const { return available_; }

  // Where to start from without a last estimate: the pose on springs, with the measured tensions.
  RobotForces coldStart(const Pose& seed, int* iterations) const {
    RobotForces start;
    start.pose = seed;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      const CableLine line = cableLine(robot_.cables[i], seed);
      lengths.push_back(measurements_.lengths[i].value_or(std::hypot(line.x, line.w)));
    }
    static_cast<void>(roughStart(robot_, Wrench::Zero(), lengths, deadline_, &start, iterations));
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      if (!measurements_.tensions[i] || *measurements_.tensions[i] == 0.0) continue;
      const CableLine line = cableLine(robot_.cables[i], start.pose);
      const double chord = std::hypot(line.x, line.w);
      if (lengths[i] > 1.05 * chord) continue;
      const double weight = robot_.cables[i].properties.weight * lengths[i];
      start.forces[i] = {*measurements_.tensions[i] * line.x / chord,
                         0.5 * weight - *measurements_.tensions[i] * line.w / chord};
    }
    return start;
  }

  // Adjusts, and leaves out what is faulty, always from the same start. A gross error bends the whole estimate and
  // shows in many residuals: which of the worst ones is at fault, leaving each out in turn tells.
  Candidate snoop(const RobotForces& start, const Selection& selection) const {
    Candidate candidate = adjusted(start, selection);
    while (candidate.adjusted.status.ok() && candidate.adjusted.redundancy > 0) {
      std::vector<Observation> worst = suspects(candidate.adjusted.observations, options_.outlier_threshold);
      if (worst.empty()) break;
      if (worst.size() > kSuspects) worst.erase(worst.begin() + kSuspects, worst.end());
      std::optional<Candidate> best;
      for (const Observation& suspect : worst) {
        Selection without = candidate.selection;
        leaveOut(suspect, &without);
        Candidate trial = adjusted(start, without);
        if (!trial.adjusted.status.ok()) continue;
        if (!best || trial.adjusted.weighted_squares < best->adjusted.weighted_squares) best = std::move(trial);
      }
      if (!best) break;
      candidate = std::move(*best);
    }
    return candidate;
  }

  // Leaves out what has jumped since the last estimate while most measurements have not: a drum's turn bends the
  // estimate so far that its residual no longer tells it from others. What agrees in the end is taken back.
  void leaveOutJumps(const RobotForces& last, Selection* selection) const {
    std::vector<double> lengths, tensions;
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      const double tension = std::hypot(last.forces[i].horizontal, last.forces[i].vertical);
      lengths.push_back(available_.lengths[i] ? std::abs(*measurements_.lengths[i] - last.lengths[i]) : 0.0);
      tensions.push_back(available_.tensions[i] ? std::abs(*measurements_.tensions[i] - tension) : 0.0);
    }
    const auto limit = [&](std::vector<double> jumps, double stddev) {
      std::nth_element(jumps.begin(), jumps.begin() + jumps.size() / 2, jumps.end());
      return kJump * std::max(jumps[jumps.size() / 2], stddev) + options_.outlier_threshold * stddev;
    };
    const double length_limit = limit(lengths, options_.length_stddev);
    const double tension_limit = limit(tensions, options_.tension_stddev);
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      if (lengths[i] > length_limit) selection->lengths[i] = false;
      if (tensions[i] > tension_limit) selection->tensions[i] = false;
    }
  }

  // Takes back, one by one, what was left out on suspicion and does not disturb.
  void takeBack(const RobotForces& start, Candidate* candidate) const {
    const double allowed = options_.outlier_threshold * options_.outlier_threshold;
    const auto attempt = [&](const Selection& with) {
      Candidate trial = adjusted(start, with);
      if (trial.adjusted.status.ok() &&
          trial.adjusted.weighted_squares < candidate->adjusted.weighted_squares + allowed &&
          suspects(trial.adjusted.observations, options_.outlier_threshold).empty()) {
        *candidate = std::move(trial);
      }
    };
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      Selection with = candidate->selection;
      with.lengths[i] = available_.lengths[i];
      if (with.lengths[i] != candidate->selection.lengths[i]) attempt(with);
      with = candidate->selection;
      with.tensions[i] = available_.tensions[i];
      if (with.tensions[i] != candidate->selection.tensions[i]) attempt(with);
    }
  }

  // An adjustment that explains its measurements within what the threshold lets pass.
  bool good(const Candidate& candidate) const {
    const Adjusted& a = candidate.adjusted;
    const double limit = options_.outlier_threshold * options_.outlier_threshold * std::max(a.redundancy, 1);
    return a.status.ok() && a.weighted_squares < limit;
  }

  Estimate estimate(const Candidate& candidate) const;

 private:
  Candidate adjusted(const RobotForces& start, const Selection& selection) const {
    return {adjust(robot_, options_, measurements_, selection, start, deadline_), selection};
  }
  void fillCables(const Adjusted& adjusted, Estimate* estimate) const;
  void fillCovariance(const Eigen::MatrixXd& information, Estimate* estimate) const;

  const RobotDescription& robot_;
  const EstimatorOptions& options_;
  const CableMeasurements& measurements_;
  const Clock::time_point deadline_;
  Selection available_;
};

void Update::fillCables(const Adjusted& adjusted, Estimate* estimate) const {
  std::vector<CableSolution> cables;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CableLine line = cableLine(robot_.cables[i], adjusted.unknowns.pose);
    cables.push_back(adjusted.cables[i].describe(line.x, line.w, options_.profile_points));
  }
  assemble(robot_, estimate->load, cables, &estimate->solution);
}

void Update::fillCovariance(const Eigen::MatrixXd& information, Estimate* estimate) const {
  const auto n = static_cast<Eigen::Index>(robot_.freedoms());
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(n);  // rotations as displacements of the platform's rim
  if (n == 6) scale.tail<3>().setConstant(1.0 / std::max(robot_.platformRadius(), 1e-6 * robot_.span()));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scale.asDiagonal() * information * scale.asDiagonal());
  const double least = 1.0 / std::pow(kUnobservable * robot_.span(), 2);
  estimate->covariance = kUnknownVariance * Eigen::Matrix<double, 6, 6>::Identity();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::VectorXd direction = scale.asDiagonal() * eigen.eigenvectors().col(k);
    const bool fixed = eigen.eigenvalues()(k) > least;
    if (!fixed) ++estimate->unobservable_directions;
    const double variance = fixed ? 1.0 / eigen.eigenvalues()(k) : kUnknownVariance / direction.squaredNorm();
    covariance += variance * direction * direction.transpose();
  }
  estimate->covariance.topLeftCorner(n, n) = covariance;
}

Estimate Update::estimate(const Candidate& candidate) const {
  Estimate estimate;
  const Adjusted& adjusted = candidate.adjusted;
  const RobotForces& at = adjusted.unknowns;
  estimate.solution.pose = at.pose;
  estimate.solution.report.status = adjusted.status;
  Wrench cables = Wrench::Zero();
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CableLine line = cableLine(robot_.cables[i], at.pose);
    cables += wrenchAt(line.arm, forceOnPlatform(line, at.forces[i].horizontal, at.forces[i].vertical,
                                                 robot_.cables[i].properties.weight * at.lengths[i]));
    const double tension = std::hypot(at.forces[i].horizontal, at.forces[i].vertical);
    estimate.length_residual.push_back(available_.lengths[i] ? *measurements_.lengths[i] - at.lengths[i] : 0.0);
    estimate.tension_residual.push_back(available_.tensions[i] ? *measurements_.tensions[i] - tension : 0.0);
    estimate.length_outlier.push_back(available_.lengths[i] && !candidate.selection.lengths[i]);
    estimate.tension_outlier.push_back(available_.tensions[i] && !candidate.selection.tensions[i]);
  }
  estimate.load = -cables - loadWrench(robot_, at.pose, Wrench::Zero());
  if (robot_.type == PlatformType::kPointMass) estimate.load.tail<3>().setZero();
  estimate.length_redundancy.assign(robot_.cables.size(), 0.0);
  estimate.tension_redundancy.assign(robot_.cables.size(), 0.0);
  for (const Observation& o : adjusted.observations) {
    if (o.kind == Observation::Kind::kLength) estimate.length_redundancy[o.index] = o.redundancy;
    if (o.kind == Observation::Kind::kTension) estimate.tension_redundancy[o.index] = o.redundancy;
  }
  estimate.load_outlier = available_.load && !candidate.selection.load;
  estimate.weighted_squares = adjusted.weighted_squares;
  estimate.redundancy = adjusted.redundancy;
  fillCovariance(adjusted.information, &estimate);
  fillCables(adjusted, &estimate);
  if (estimate.unobservable_directions > 0) {
    std::ostringstream text;
    text << "the measurements leave " << estimate.unobservable_directions
         << " direction(s) of the pose unknown; they carry a variance of " << kUnknownVariance;
    estimate.solution.report.status.message = text.str();
  }
  return estimate;
}

}  // namespace

Wrench EstimatorOptions::defaultLoadStddev(const RobotDescription& robot) {
  Wrench stddev;
  stddev << Eigen::Vector3d::Constant(0.01 * robot.weight()),
      Eigen::Vector3d::Constant(0.01 * robot.weight() * std::max(robot.platformRadius(), 1e-6 * robot.span()));
  return stddev;
}

bool EstimatorOptions::isValid(std::string* error) const {
  std::ostringstream text;
  if (!(length_stddev > 0.0 && std::isfinite(length_stddev))) {
    text << "length_stddev = " << length_stddev << " m must be positive";
  } else if (!(tension_stddev > 0.0 && std::isfinite(tension_stddev))) {
    text << "tension_stddev = " << tension_stddev << " N must be positive";
  } else if (!load_stddev.allFinite() || load_stddev.minCoeff() <= 0.0) {
    text << "load_stddev must be six positive numbers";
  } else if (!(outlier_threshold > 0.0)) {
    text << "outlier_threshold = " << outlier_threshold << " must be positive";
  }
  *error = text.str();
  return error->empty();
}

PoseEstimator::PoseEstimator(const RobotDescription& robot, const EstimatorOptions& options)
    : robot_(robot), options_(options), seed_(robot.home) {}

Estimate PoseEstimator::update(const CableMeasurements& measurements) {
  const Clock::time_point begin = Clock::now();
  const Status check = checkMeasurements(robot_, measurements);
  Estimate estimate;
  if (!check.ok()) {
    estimate.solution = refusedRobot(options_.model, check);
    return estimate;
  }
  const Update update(robot_, options_, measurements);
  Candidate best;
  const bool warm = last_.has_value();
  if (warm) {
    Selection selection = update.available();
    for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
      if (last_length_outlier_[i]) selection.lengths[i] = false;
      if (last_tension_outlier_[i]) selection.tensions[i] = false;
    }
    update.leaveOutJumps(*last_, &selection);
    best = update.snoop(*last_, selection);
    if (best.adjusted.status.ok()) update.takeBack(*last_, &best);
  }
  estimate.warm_started = warm;
  int iterations = best.adjusted.iterations;
  if (!warm || !update.good(best)) {
    const RobotForces start = update.coldStart(warm ? last_->pose : seed_, &iterations);
    const Candidate cold = update.snoop(start, update.available());
    iterations += cold.adjusted.iterations;
    const bool better =
        !best.adjusted.status.ok() ||
        (cold.adjusted.status.ok() && (cold.adjusted.redundancy > best.adjusted.redundancy ||
                                       cold.adjusted.weighted_squares < best.adjusted.weighted_squares));
    if (better) {
      best = cold;
      estimate.warm_started = false;
    }
  }
  if (!best.adjusted.status.ok()) {
    last_.reset();
    estimate.solution = refusedRobot(options_.model, best.adjusted.status);
    return estimate;
  }
  const bool warm_started = estimate.warm_started;
  estimate = update.estimate(best);
  estimate.warm_started = warm_started;
  estimate.solution.report.iterations = iterations;
  last_ = best.adjusted.unknowns;
  last_length_outlier_ = estimate.length_outlier;
  last_tension_outlier_ = estimate.tension_outlier;
  estimate.solution.report.solve_time = std::chrono::duration<double>(Clock::now() - begin).count();
  return estimate;
}

void PoseEstimator::reset() {
  last_.reset();
  seed_ = robot_.home;
}

void PoseEstimator::setPose(const Pose& seed) {
  last_.reset();
  seed_ = seed;
}

}  // namespace cdpr_kinetostatics
