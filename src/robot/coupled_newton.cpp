#include "robot/coupled_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cable/iteration_schedule.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

// Farthest that the platform moves in one iteration: a share of the robot's span, and an angle.
constexpr double kMaxShareOfSpan = 0.05;
constexpr double kMaxRotation = 0.2;  // [rad]

// Newton steps of a prediction: one for the lengths, one for the circles that the cables' ends move on.
constexpr int kPredictorIterations = 2;
constexpr double kNowhere = std::numeric_limits<double>::infinity();

// Share of the cable's length: nearer to the vertical through A than that, H/x does not change as B moves.
constexpr double kLeastDistance = 1e-9;

// What rounding leaves: of a cable's closure, relative to its length, and of the balance, relative to the weight.
constexpr double kRoundingOfClosure = 1e-13;
constexpr double kRoundingOfBalance = 1e-9;

}  // namespace

bool CoupledNewton::linearise(const Wrench& external, Steps steps, CoupledState* state) {
  unbalanced_ = loadWrench(robot_, state->pose, external);
  linear_.start(state->pose);
  closure_defect_ = open_ = 0.0;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    SaggingCable& cable = state->cables[i];
    const bool adapt = steps == Steps::kNew || (steps == Steps::kNewWhereDue && !cable.stepsFit());
    if (!cable.linearise(adapt)) return false;
    Elimination& e = cables_[i];
    e.plane = cablePlane(robot_.cables[i], state->pose);
    const Eigen::Matrix<double, 2, 3>& jacobian = cable.end().jacobian;
    e.stiffness = jacobian.leftCols<2>().inverse();
    e.by_length = -e.stiffness * jacobian.col(2);
    const Eigen::Vector2d defect = Eigen::Vector2d(e.plane.x, e.plane.y) - cable.end().position;
    const double open = defect.norm();
    open_ = std::max(open_, open);
    closure_defect_ = std::max(closure_defect_, open / cable.length());
    e.start = e.stiffness * defect;

    e.at_b = forcesAtB(cable);
    const Eigen::Vector2d start_at_b = e.at_b * e.start;
    const double weight = cable.properties().weight * cable.freeLength();
    const double h = cable.horizontalForce() + e.start.x();
    const Eigen::Vector3d force = forceOnPlatform(e.plane, h, cable.verticalForceA() + start_at_b.y(), weight);
    unbalanced_ += wrenchAt(e.plane.arm, force);
    linear_.add(e.plane, e.at_b * e.stiffness, h, force);
  }
  return unbalanced_.allFinite() && linear_.stiffness().allFinite();
}

bool CoupledNewton::solve() {
  if (!linear_.factorise() && !linear_.factoriseWithOpenMotions()) return false;
  pose_step_ = linear_.displacement(unbalanced_);
  pose_step_.tail<3>() *= 1.0 / linear_.lever();
  return pose_step_.allFinite();
}

double CoupledNewton::predict(const std::vector<double>& lengths, const Wrench& external, CoupledState* state) {
  laws_.resize(cables_.size());
  forces_.resize(cables_.size());
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const CablePlane plane = cablePlane(robot_.cables[i], state->pose);
    laws_[i] = ChordLaw(state->cables[i], plane, cables_[i].stiffness, cables_[i].by_length, lengths[i]);
  }
  Pose pose = state->pose;
  if (!predictPose(external, &pose)) return kNowhere;
  double size = std::max((pose.position - state->pose.position).norm() / robot_.span(),
                         pose.orientation.angularDistance(state->pose.orientation));
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    SaggingCable& cable = state->cables[i];
    const Eigen::Vector3d change(forces_[i].x() - cable.horizontalForce(), forces_[i].y() - cable.verticalForceA(),
                                 lengths[i] - cable.length());
    if (!change.allFinite()) return kNowhere;
    size = std::max(size, change.head<2>().norm() / cable.tensionA());
    cable.follow(change);
  }
  state->pose = pose;
  return size;
}

bool CoupledNewton::predictPose(const Wrench& external, Pose* pose) {
  for (int iteration = 0; iteration <= kPredictorIterations; ++iteration) {
    unbalanced_ = loadWrench(robot_, *pose, external);
    linear_.start(*pose);
    for (std::size_t i = 0; i < cables_.size(); ++i) {
      const CablePlane plane = cablePlane(robot_.cables[i], *pose);
      const ChordLaw::Value value = laws_[i].at(plane);
      forces_[i] = value.forces;
      const Eigen::Vector3d force = laws_[i].forceOnPlatform(plane, value);
      unbalanced_ += wrenchAt(plane.arm, force);
      linear_.add(plane, value.stiffness, value.forces.x(), force);
    }
    if (iteration == kPredictorIterations) break;
    if (!unbalanced_.allFinite() || !solve()) return false;
    *pose = displaced(*pose, pose_step_.head<3>(), pose_step_.tail<3>());
  }
  return true;
}

Eigen::Vector3d CoupledNewton::change(const Elimination& e) const {
  const Eigen::Vector3d moved = pose_step_.head<3>() + pose_step_.tail<3>().cross(e.plane.arm);
  const Eigen::Vector2d forces = e.start + e.stiffness * Eigen::Vector2d(e.plane.direction.dot(moved), moved.z());
  return {forces.x(), forces.y(), 0.0};
}

double CoupledNewton::size(const CoupledState& state) const {
  double size = std::max(pose_step_.head<3>().norm() / robot_.span(), pose_step_.tail<3>().norm());
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const SaggingCable& cable = state.cables[i];
    const Eigen::Vector3d step = change(cables_[i]);
    size = std::max({size, step.head<2>().norm() / cable.tensionA(), cable.angleChange(step)});
  }
  return size;
}

bool CoupledNewton::atRounding() const {
  return closure_defect_ < kRoundingOfClosure &&
         unbalanced_.head(robot_.freedoms()).norm() < kRoundingOfBalance * robot_.weight();
}

Residuals CoupledNewton::residuals() const {
  Wrench wrench = unbalanced_;
  for (const Elimination& e : cables_) wrench -= wrenchByForces(e.plane) * (e.at_b * e.start).eval();
  return {open_, wrench.head<3>().norm(), robot_.freedoms() == 6 ? wrench.tail<3>().norm() : 0.0};
}

void CoupledNewton::step(CoupledState* state) const {
  double damping = 1.0;
  const double translation = pose_step_.head<3>().norm();
  const double rotation = pose_step_.tail<3>().norm();
  if (translation > kMaxShareOfSpan * robot_.span()) damping = kMaxShareOfSpan * robot_.span() / translation;
  if (rotation > kMaxRotation) damping = std::min(damping, kMaxRotation / rotation);
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    damping = std::min(damping, state->cables[i].dampingFor(change(cables_[i])));
  }
  state->pose = displaced(state->pose, damping * pose_step_.head<3>(), damping * pose_step_.tail<3>());
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    // H/x, the horizontal force density, is what stays smooth where B passes below A: it is stepped, and
    // H follows from the new x.
    SaggingCable& cable = state->cables[i];
    const Elimination& e = cables_[i];
    const Eigen::Vector3d moved = pose_step_.head<3>() + pose_step_.tail<3>().cross(e.plane.arm);
    const double density = forceDensity(e.plane, cable.horizontalForce(), e.stiffness);
    Eigen::Vector3d step = change(e);
    const double least = kLeastDistance * cable.length();
    const double density_step =
        e.plane.x > least ? (step.x() - density * e.plane.direction.dot(moved)) / e.plane.x : 0.0;
    const double new_x = cablePlane(robot_.cables[i], state->pose).x;
    step.x() = ((density + damping * density_step) * new_x - cable.horizontalForce()) / damping;
    cable.step(step, damping);
  }
}

void readForces(const CoupledState& state, RobotForces* forces) {
  forces->pose = state.pose;
  forces->lengths.clear();
  forces->forces.clear();
  for (const SaggingCable& cable : state.cables) {
    forces->lengths.push_back(cable.length());
    forces->forces.push_back({cable.horizontalForce(), cable.verticalForceA()});
  }
}

SearchOutcome solveCoupled(const Wrench& external, const CoupledOptions& options, CoupledNewton* newton,
                           CoupledState* state) {
  SearchOutcome outcome;
  bool adapt = true;
  double last_size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < options.max_iterations; ++i) {
    if (std::chrono::steady_clock::now() > options.deadline) {
      outcome.status = {Code::kTimedOut, "the time allowed ran out while the platform's pose was refined"};
      return outcome;
    }
    ++outcome.iterations;
    if (!newton->linearise(external, adapt ? Steps::kNew : Steps::kKept, state)) break;
    outcome.residuals = newton->residuals();
    if (!newton->solve()) {
      outcome.status = {Code::kNotConverged,
                        "the robot's stiffness cannot be evaluated here: a cable cannot give at all"};
      return outcome;
    }
    const double size = newton->size(*state);
    newton->step(state);
    if (!adapt && (size <= options.tolerance || (hasStoppedShrinking(size, last_size) && newton->atRounding()))) {
      outcome.status.code = Code::kConverged;
      return outcome;
    }
    adapt = choosesStepsNext(size, i);
    last_size = size;
  }
  outcome.status = {Code::kNotConverged, "Newton's method on the platform's pose did not converge"};
  return outcome;
}

bool isOnBranch(const PlatformStability& stability, const CoupledState& state) {
  return stability.kind != Stability::kUnstable &&
         std::all_of(state.cables.begin(), state.cables.end(),
                     [](const SaggingCable& cable) { return cable.onBranch(); });
}

}  // namespace cdpr_kinetostatics
