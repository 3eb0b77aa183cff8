#include "cdpr_kinetostatics/robot/inverse.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/modelling_effect.h"
#include "cdpr_kinetostatics/robot/platform_statics.h"
#include "cdpr_kinetostatics/robot/rung_choice.h"
#include "cdpr_kinetostatics/robot/solution_assembly.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMaxIterations = 2000;

// How far the starting rung is taken where another one follows.
constexpr double kRough = 1e-3;

// Limits that still contradict each other after so many iterations do.
constexpr int kIterationsToFeasibility = 8;

// Below this multiple of its weight a cable may come near the least tension that can hold it.
constexpr double kNearFold = 3.0;
constexpr double kAboveFold = 1.001;
constexpr double kLoopExcess = 1.02;  // a fold lies at more length over chord than this

// Largest turn of a free attitude in one iteration, and the weight of a turn in the objective, which decides
// only where equilibrium and tensions leave the attitude free.
constexpr double kMaxTurn = 0.2;      // [rad]
constexpr double kTurnWeight = 1e-2;  // [1/rad]

// Below this size of a step the integration of bending cables keeps its grid.
constexpr double kFreezeBelow = 1e-3;
// And after so many iterations in any case: forces of cables that hardly stretch jitter with the grid.
constexpr int kAdaptiveIterations = 10;

// Imbalance that counts as equilibrium, relative to the platform's weight.
constexpr double kBalance = 1e-9;

struct InverseCable {
  SaggingCable cable;
  CableLine line;
  double lower = 0.0;  // limits of T_A in use [N]
  double upper = 0.0;
  // (H, V, L) change by start + by_tension * (t - T_A) + by_turn * rotation.
  Eigen::Vector3d start, by_tension;
  Eigen::Matrix3d by_turn;

  Eigen::Vector3d change(double tension, const Eigen::Vector3d& turn) const {
    return start + by_tension * (tension - cable.tensionA()) + by_turn * turn;
  }
};

// Sequential quadratic programming: cables are linearised, the nearest tensions to the preferred ones that
// balance the platform within the limits are found exactly, all cables step towards them.
class InverseSolve {
 public:
  InverseSolve(const RobotDescription& robot, const InverseRequest& request, const RobotSolverOptions& options,
               Clock::time_point deadline)
      : robot_(robot),
        request_(request),
        options_(options),
        deadline_(deadline),
        pose_(request.pose),
        free_turn_(request.free_orientation && robot.type == PlatformType::kRigidBody),
        preferred_(static_cast<Eigen::Index>(robot.cables.size())) {
    for (Eigen::Index i = 0; i < preferred_.size(); ++i) {
      const CableDescription& cable = robot.cables[i];
      preferred_(i) = request.preferred_tensions.empty() ? 0.5 * (cable.tension_min + cable.tension_max)
                                                         : request.preferred_tensions[i];
    }
    tensions_ = preferred_;
  }

  RobotSolution run() {
    const bool choose = options_.model == Model::kAuto;
    Status status = startCables();
    std::vector<Model> rungs(robot_.cables.size(), options_.model);
    if (status.ok() && startingRung(options_.model) != options_.model) {
      status = iterate(kRough);
      if (choose && status.ok()) rungs = RungChoice().choose(robot_, reached(), options_.accuracy, {});
      useRungs(rungs);
    }
    if (status.ok()) status = iterate(options_.tolerance);
    if (status.ok()) status = checkBranches();
    if (!status.ok()) return refusedRobot(options_.model, status);
    RobotSolution found = solution(status);
    while (choose && !isWithin(robot_, found, options_.accuracy) && refineRungs(&rungs)) {
      useRungs(rungs);
      status = iterate(options_.tolerance);
      if (status.ok()) status = checkBranches();
      if (!status.ok()) return refusedRobot(options_.model, status);
      found = solution(status);
    }
    return found;
  }

 private:
  RobotSolution solution(const Status& status) const {
    RobotSolution solution;
    solution.pose = pose_;
    solution.report.status = status;
    solution.report.iterations = iterations_;
    std::vector<CableSolution> cables;
    for (std::size_t i = 0; i < cables_.size(); ++i) {
      const CableLine line = cableLine(robot_.cables[i], pose_);
      cables.push_back(cables_[i].cable.describe(line.x, line.w, options_.profile_points));
    }
    assemble(robot_, request_.external_wrench, cables, &solution);
    return solution;
  }

  RobotForces reached() const;
  Status startCables();
  void useRungs(const std::vector<Model>& rungs);
  Status iterate(double tolerance);
  Status checkBranches() const;
  bool linearise(bool adapt);
  TensionDistribution distribute();
  bool pullBackFromFolds();
  bool raiseLimitsToFolds(const Eigen::VectorXd& tensions);
  Status contradiction(const TensionDistribution& distribution) const;
  Status unbalanced(double imbalance) const;

  double armScale() const { return std::max(robot_.platformRadius(), 1e-6 * robot_.span()); }

  const RobotDescription& robot_;
  const InverseRequest& request_;
  const RobotSolverOptions& options_;
  const Clock::time_point deadline_;
  Pose pose_;
  const bool free_turn_;
  Eigen::VectorXd preferred_;
  Eigen::VectorXd tensions_;
  double turn_weight_ = kTurnWeight;
  std::vector<InverseCable> cables_;
  int iterations_ = 0;
};

// Every cable at its preferred tension, moved into its limits, on the closed-form rung.
Status InverseSolve::startCables() {
  CableSolverOptions options;
  options.model = startingRung(options_.model);
  options.tolerance = 1e-6;
  options.deadline = deadline_;
  for (std::size_t i = 0; i < robot_.cables.size(); ++i) {
    const CableDescription& description = robot_.cables[i];
    InverseCable cable;
    cable.cable = SaggingCable(description.properties, options.model, options_.tolerance);
    cable.line = cableLine(description, pose_);
    cable.lower = description.tension_min;
    cable.upper = description.tension_max;
    double& tension = tensions_(static_cast<Eigen::Index>(i));
    tension = std::clamp(tension, std::max(cable.lower, 1e-9 * cable.upper), cable.upper);
    CableSolution start = findLength(description.properties, cable.line.x, cable.line.w, tension, 0.0, options);
    if (start.status.code == Code::kInfeasible && start.least_tension > 0.0) {
      cable.lower = kAboveFold * start.least_tension;
      tension = cable.lower;
      start = findLength(description.properties, cable.line.x, cable.line.w, tension, 0.0, options);
    }
    if (!start.status.ok()) {
      return {start.status.code, "cable '" + description.name + "': " + start.status.message};
    }
    cable.cable.start(start.length, {start.horizontal_force, start.vertical_force_a});
    cables_.push_back(std::move(cable));
  }
  return {Code::kConverged, ""};
}

RobotForces InverseSolve::reached() const {
  RobotForces forces;
  forces.pose = pose_;
  for (const InverseCable& c : cables_) {
    forces.lengths.push_back(c.cable.length());
    forces.forces.push_back({c.cable.horizontalForce(), c.cable.verticalForceA()});
  }
  return forces;
}

// The same forces and lengths on other rungs.
void InverseSolve::useRungs(const std::vector<Model>& rungs) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const SaggingCable& old = cables_[i].cable;
    if (old.model() == rungs[i]) continue;
    SaggingCable cable(robot_.cables[i].properties, rungs[i], options_.tolerance);
    cable.start(old.length(), {old.horizontalForce(), old.verticalForceA()});
    cables_[i].cable = std::move(cable);
  }
}

bool InverseSolve::linearise(bool adapt) {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    InverseCable& c = cables_[i];
    if (!c.cable.linearise(adapt)) return false;
    c.line = cableLine(robot_.cables[i], pose_);
    const double tension = c.cable.tensionA();
    Eigen::Matrix3d system;
    system << c.cable.end().jacobian, c.cable.horizontalForce() / tension, c.cable.verticalForceA() / tension, 0.0;
    const Eigen::Matrix3d inverse = system.inverse();
    const Eigen::Vector2d defect = Eigen::Vector2d(c.line.x, c.line.w) - c.cable.end().position;
    Eigen::Matrix<double, 2, 3> in_plane;
    in_plane << c.line.direction.transpose(), Eigen::RowVector3d::UnitZ();
    c.start = inverse.leftCols<2>() * defect;
    c.by_tension = inverse.col(2);
    c.by_turn = inverse.leftCols<2>() * in_plane * -cross(c.line.arm);
    if (!inverse.allFinite()) return false;
  }
  return true;
}

TensionDistribution InverseSolve::distribute() {
  const auto n = static_cast<Eigen::Index>(cables_.size());
  const int rows = robot_.freedoms();
  const Eigen::Index variables = n + (free_turn_ ? 3 : 0);
  Wrench scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / armScale());

  Wrench total = loadWrench(robot_, pose_, request_.external_wrench);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, variables);
  if (free_turn_) matrix.rightCols<3>() = weightStiffness(robot_, pose_).rightCols<3>();
  TensionProblem problem;
  problem.preferred = Eigen::VectorXd::Zero(variables);
  problem.weight = Eigen::VectorXd::Constant(variables, turn_weight_);
  problem.lower = Eigen::VectorXd::Constant(variables, -kMaxTurn);
  problem.upper = Eigen::VectorXd::Constant(variables, kMaxTurn);
  for (Eigen::Index i = 0; i < n; ++i) {
    const InverseCable& c = cables_[i];
    const double q = c.cable.properties().weight;
    Eigen::Matrix3d force_by_cable;  // by (H, V, L)
    force_by_cable << -c.line.direction, Eigen::Vector3d::UnitZ(), -q * Eigen::Vector3d::UnitZ();
    const double h = c.cable.horizontalForce() + c.start.x();
    const Eigen::Vector3d force =
        forceOnPlatform(c.line, c.cable.horizontalForce(), c.cable.verticalForceA(), q * c.cable.length()) +
        force_by_cable * c.start;
    matrix.col(i) = wrenchAt(c.line.arm, force_by_cable * c.by_tension);
    total += wrenchAt(c.line.arm, force) - matrix.col(i) * c.cable.tensionA();
    if (free_turn_) {
      const Eigen::Vector3d side(-c.line.direction.y(), c.line.direction.x(), 0.0);
      const double across = h / std::max(c.line.x, 1e-9 * c.cable.length());
      const Eigen::Matrix3d arm = cross(c.line.arm);
      const Eigen::Matrix3d force_by_turn = force_by_cable * c.by_turn + across * side * side.transpose() * arm;
      matrix.topRightCorner<3, 3>() += force_by_turn;
      matrix.bottomRightCorner<3, 3>() += arm * force_by_turn + cross(force) * arm;
    }
    problem.preferred(i) = preferred_(i);
    problem.weight(i) = 1.0 / (robot_.cables[i].tension_max - robot_.cables[i].tension_min);
    problem.lower(i) = c.lower;
    problem.upper(i) = c.upper;
  }
  problem.matrix = (scale.asDiagonal() * matrix).topRows(rows);
  problem.wrench = -(scale.asDiagonal() * total).head(rows);
  return distributeTensions(problem);
}

// A tension below the least one that can hold its cable has no length: raises the limit where that would be
// asked for. True if a limit was raised.
bool InverseSolve::raiseLimitsToFolds(const Eigen::VectorXd& tensions) {
  if (isStraight(options_.model)) return false;
  CableSolverOptions options;
  options.model = startingRung(options_.model);
  options.tolerance = 1e-6;
  options.deadline = deadline_;
  bool raised = false;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    InverseCable& c = cables_[i];
    const double tension = tensions(static_cast<Eigen::Index>(i));
    if (tension >= kNearFold * c.cable.properties().weight * std::hypot(c.line.x, c.line.w)) continue;
    const CableSolution at =
        findLength(robot_.cables[i].properties, c.line.x, c.line.w, std::max(tension, 1e-12 * c.upper), 0.0, options);
    if (at.status.ok() || at.least_tension <= c.lower) continue;
    c.lower = kAboveFold * at.least_tension;
    raised = true;
  }
  return raised;
}

// A cable that has stepped over its fold hangs in a deep loop, where more tension means more length: it starts
// anew on the taut side. True if there was one.
bool InverseSolve::pullBackFromFolds() {
  if (isStraight(options_.model)) return false;
  CableSolverOptions options;
  options.model = startingRung(options_.model);
  options.tolerance = 1e-6;
  options.deadline = deadline_;
  bool any = false;
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    InverseCable& c = cables_[i];
    if (c.by_tension.z() <= 0.0 || c.cable.length() < kLoopExcess * std::hypot(c.line.x, c.line.w)) continue;
    const CableProperties& properties = robot_.cables[i].properties;
    CableSolution taut = findLength(properties, c.line.x, c.line.w, c.cable.tensionA(), 0.0, options);
    if (!taut.status.ok() && taut.least_tension > 0.0) {
      c.lower = std::max(c.lower, kAboveFold * taut.least_tension);
      taut = findLength(properties, c.line.x, c.line.w, c.lower, 0.0, options);
    }
    if (!taut.status.ok()) continue;
    c.cable.start(taut.length, {taut.horizontal_force, taut.vertical_force_a});
    any = true;
  }
  return any;
}

Status InverseSolve::iterate(double tolerance) {
  bool adapt = true;
  double last_size = std::numeric_limits<double>::infinity();
  Eigen::Vector3d last_turn = Eigen::Vector3d::Zero();
  for (int i = 0; i < kMaxIterations; ++i) {
    if (Clock::now() > deadline_) {
      return {Code::kTimedOut, "the time allowed ran out while the tensions were distributed"};
    }
    ++iterations_;
    if (!linearise(adapt)) break;
    if (pullBackFromFolds() && !linearise(true)) break;
    TensionDistribution distribution = distribute();
    for (int k = 0; k < 3 && raiseLimitsToFolds(distribution.tensions); ++k) distribution = distribute();
    const auto n = static_cast<Eigen::Index>(cables_.size());
    const Eigen::VectorXd tensions = distribution.tensions.head(n);
    const Eigen::Vector3d turn =
        free_turn_ ? Eigen::Vector3d(distribution.tensions.tail<3>()) : Eigen::Vector3d::Zero();
    double damping = 1.0;
    // A heavy turn takes short steps: what counts is the slope that is left.
    double size = turn.norm() * std::max(1.0, turn_weight_ * turn_weight_);
    for (Eigen::Index k = 0; k < n; ++k) {
      const InverseCable& c = cables_[k];
      const Eigen::Vector3d change = c.change(tensions(k), turn);
      if (!change.allFinite())
        return {Code::kNotConverged, "the tensions did not settle: a cable has no stiffness here"};
      damping = std::min(damping, c.cable.dampingFor(change));
      size = std::max({size, change.head<2>().norm() / c.cable.tensionA(), std::abs(change.z()) / c.cable.length(),
                       c.cable.angleChange(change)});
    }
    for (Eigen::Index k = 0; k < n; ++k) cables_[k].cable.step(cables_[k].change(tensions(k), turn), damping);
    pose_ = displaced(pose_, Eigen::Vector3d::Zero(), damping * turn);
    // The turn has no curvature in the linearised problem: where it swings, its weight grows.
    if (i > 0 && (turn.dot(last_turn) < 0.0 || size > 1.5 * last_size)) turn_weight_ *= 1.5;
    last_turn = turn;
    const bool settled = size <= tolerance || (size < 1e-6 && size >= 0.5 * last_size);
    if ((settled && !adapt) || i >= kIterationsToFeasibility) {
      if (!distribution.feasible) return contradiction(distribution);
    }
    if (settled && !adapt) {
      if (distribution.imbalance > kBalance * robot_.weight()) return unbalanced(distribution.imbalance);
      return {Code::kConverged, ""};
    }
    adapt = size > kFreezeBelow && i < kAdaptiveIterations;
    last_size = size;
  }
  return {Code::kNotConverged, "the tensions did not settle at this pose"};
}

// A cable that pushes has no place in a solution with tension limits above zero.
Status InverseSolve::checkBranches() const {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    const SaggingCable& cable = cables_[i].cable;
    if (cable.pushes() && robot_.cables[i].tension_min > 0.0) {
      return {Code::kInfeasible,
              "cable '" + robot_.cables[i].name + "' would be in compression, which its tension_min forbids"};
    }
    if (!cable.onBranch()) {
      return {Code::kWrongBranch,
              "cable '" + robot_.cables[i].name + "' ended in an equilibrium that is not the sagging one"};
    }
  }
  return {Code::kConverged, ""};
}

Status InverseSolve::contradiction(const TensionDistribution& distribution) const {
  std::ostringstream text;
  text << "no tensions within the limits balance the load at this pose; these limits cannot all be met:";
  const char* separator = " ";
  const auto n = static_cast<int>(cables_.size());
  for (const int i : distribution.at_lower) {
    if (i >= n) continue;
    const bool fold = cables_[i].lower > robot_.cables[i].tension_min;
    text << separator << "'" << robot_.cables[i].name << "' "
         << (fold ? "least tension that can hold the cable " : "tension_min ") << cables_[i].lower << " N";
    separator = ", ";
  }
  for (const int i : distribution.at_upper) {
    if (i >= n) continue;
    text << separator << "'" << robot_.cables[i].name << "' tension_max " << cables_[i].upper << " N";
    separator = ", ";
  }
  return {Code::kInfeasible, text.str()};
}

Status InverseSolve::unbalanced(double imbalance) const {
  std::ostringstream text;
  text << "the " << cables_.size()
       << " cables cannot balance the load at this pose, whatever their tensions: " << imbalance
       << " N is left (moments divided by the platform's radius)";
  if (!free_turn_ && robot_.type == PlatformType::kRigidBody) {
    text << "; with free_orientation the attitude is left to equilibrium";
  }
  return {Code::kInfeasible, text.str()};
}

Status checkPreferred(const RobotDescription& robot, const std::vector<double>& preferred) {
  if (preferred.empty()) return {Code::kConverged, ""};
  std::ostringstream text;
  if (preferred.size() != robot.cables.size()) {
    text << preferred.size() << " preferred tensions were given for " << robot.cables.size() << " cables";
    return {Code::kInvalidInput, text.str()};
  }
  for (std::size_t i = 0; i < preferred.size(); ++i) {
    if (preferred[i] >= 0.0 && preferred[i] <= 1e12) continue;
    text << "preferred tension of cable '" << robot.cables[i].name << "' = " << preferred[i]
         << " N must be zero or positive and at most 1e12 N";
    return {Code::kInvalidInput, text.str()};
  }
  return {Code::kConverged, ""};
}

}  // namespace

RobotSolution solveInverse(const RobotDescription& robot, const InverseRequest& request,
                           const RobotSolverOptions& options) {
  const Clock::time_point begin = Clock::now();
  for (const Status& check :
       {checkRobotOptions(options), checkPose(request.pose), checkWrench(robot, request.external_wrench),
        checkPreferred(robot, request.preferred_tensions)}) {
    if (!check.ok()) return refusedRobot(options.model, check);
  }
  const Clock::time_point deadline = begin + std::chrono::duration_cast<Clock::duration>(options.timeout);
  RobotSolution solution = InverseSolve(robot, request, options, deadline).run();
  const Code code = solution.report.status.code;
  if (options.model == Model::kAuto &&
      (code == Code::kNotConverged || code == Code::kWrongBranch || code == Code::kInfeasible)) {
    RobotSolverOptions finest = options;
    finest.model = Model::kBending;
    solution = InverseSolve(robot, request, finest, deadline).run();
  }
  if (options.model == Model::kAuto && solution.report.status.ok()) {
    solution.report.status.message = describeChoice(solution);
  }
  solution.report.solve_time = std::chrono::duration<double>(Clock::now() - begin).count();
  return solution;
}

}  // namespace cdpr_kinetostatics
