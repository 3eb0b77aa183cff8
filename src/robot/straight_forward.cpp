#include "robot/straight_forward.h"

#include <algorithm>
#include <cmath>

#include "cable/rope_on_pulley.h"
#include "cable/sagging_cable.h"
#include "cable/text.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/linear_robot.h"
#include "robot/platform_stability.h"
#include "robot/platform_statics.h"
#include "robot/robot_gate.h"
#include "robot/solution_assembly.h"
#include "robot/spring_platform.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMaxMultiplierUpdates = 60;

// Springs that follow lines around pulleys settle by some thousandths in each turn: until a force changes by less than
// this share of the tolerance times the platform's weight.
constexpr int kMaxLineUpdates = 20;
constexpr double kSettledForce = 0.1;

// Share of its length by which a tight inextensible cable's chord may differ from it: some digits above rounding.
constexpr double kExcess = 1e-12;

// Lengths of inextensible cables that contradict each other by more than this share of a length describe no pose; real
// cables contradict each other by their stretch, their sag and their winches, some thousandths.
constexpr double kLargestMiss = 0.03;

// Lengths that miss by less than this share agree: they are known to no more digits.
constexpr double kAgreement = 1e-8;

// Least-squares pose, then the tensions that balance best.
SearchOutcome solveOverdetermined(const RobotDescription& robot, const ForwardRequest& request, double tolerance,
                                  Clock::time_point deadline, Pose* pose, std::vector<double>* tensions) {
  std::vector<Spring> springs;
  const double stiffness = robot.weight() / robot.span();
  for (const double length : request.lengths) springs.push_back({stiffness, length, 0.0, true});
  tensions->clear();
  SearchOutcome outcome = SpringPlatform(robot, nullptr).descend(springs, tolerance, deadline, pose);
  outcome.residuals = {};  // of springs that carry no load
  if (!outcome.ok()) return outcome;
  const int n = robot.freedoms();
  const double radius = n == 6 ? robot.lever() : 1.0;
  Wrench rows;
  rows << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / radius);
  Wrench needed = -loadWrench(robot, *pose, request.external_wrench);
  Eigen::MatrixXd structure(6, robot.cables.size());
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const Eigen::Vector3d arm = pose->orientation * robot.cables[i].attachment;
    const SpringWay way = springWay(robot.cables[i], *pose);
    structure.col(static_cast<Eigen::Index>(i)) = wrenchAt(arm, -way.unit);
    springs[i].held = way.length - way.chord;
    const double half_weight = springs[i].halfWeight(robot.cables[i].properties);
    needed += wrenchAt(arm, half_weight * Eigen::Vector3d::UnitZ());
  }
  const Eigen::VectorXd solution =
      nonNegativeTensions((rows.asDiagonal() * structure).topRows(n), (rows.asDiagonal() * needed).head(n));
  tensions->assign(solution.data(), solution.data() + solution.size());
  return outcome;
}

// Springs as stiff as the cables, whose shifts grow until no cable is longer than it should be.
SearchOutcome solveInextensible(const RobotDescription& robot, const ForwardRequest& request, double tolerance,
                                Clock::time_point deadline, std::vector<Spring>* springs, Pose* pose) {
  const SpringPlatform platform(robot, &request.external_wrench);
  SearchOutcome outcome;
  int iterations = 0;
  for (int i = 0; i < kMaxMultiplierUpdates; ++i) {
    outcome = platform.descend(*springs, tolerance, deadline, pose);
    outcome.iterations = iterations += outcome.iterations;
    if (!outcome.ok()) return outcome;
    double excess = 0.0;
    double open = 0.0;  // [m]
    for (std::size_t k = 0; k < springs->size(); ++k) {
      Spring& spring = (*springs)[k];
      const SpringWay way = springWay(robot.cables[k], *pose);
      const double tension = spring.tension(way.length);
      if (tension > 0.0) {
        excess = std::max(excess, std::abs(way.length / spring.length - 1.0));
        open = std::max(open, std::abs(way.length - spring.length));
      }
      spring.shift = tension;
      spring.held = way.length - way.chord;
    }
    outcome.residuals.closure = open;
    if (excess < kExcess) return outcome;
  }
  outcome.status = {Code::kNotConverged, "the inextensible cables' tensions did not settle"};
  return outcome;
}

// A spring's law is that of an eyelet without dead length: takes over what the lines between these ends really carry.
// Returns the largest change of a force [N].
double followLines(const RobotDescription& robot, const Pose& pose, double tolerance, std::vector<Spring>* springs) {
  double largest = 0.0;
  for (std::size_t i = 0; i < springs->size(); ++i) {
    const CableProperties& properties = robot.cables[i].properties;
    if (beginsAtEyelet(properties)) continue;
    Spring& spring = (*springs)[i];
    const CablePlane plane = cablePlane(robot.cables[i], pose);
    SaggingCable line(properties, Model::kStraightElastic, tolerance);
    if (!line.startBetween(spring.length, plane.x, plane.y, {tolerance}).ok()) continue;
    const double before = spring.halfWeight(properties);
    spring.held = spring.length - line.freeLength();
    const double half_weight = spring.halfWeight(properties);
    const double way = straightRope(properties, plane.x, plane.y).length();
    const double change = std::hypot(line.horizontalForce(), line.verticalForceA() - half_weight) - spring.tension(way);
    spring.shift += change;
    largest = std::max({largest, std::abs(change), std::abs(half_weight - before)});
  }
  return largest;
}

// The stable pose on elastic lines.
SearchOutcome solveElastic(const RobotDescription& robot, const ForwardRequest& request, double tolerance,
                           Clock::time_point deadline, std::vector<Spring>* springs, Pose* pose) {
  const SpringPlatform platform(robot, &request.external_wrench);
  SearchOutcome outcome = platform.descend(*springs, tolerance, deadline, pose);
  for (int i = 0; i < kMaxLineUpdates && outcome.ok(); ++i) {
    if (followLines(robot, *pose, tolerance, springs) <= kSettledForce * tolerance * robot.weight()) break;
    const int iterations = outcome.iterations;
    outcome = platform.descend(*springs, tolerance, deadline, pose);
    outcome.iterations += iterations;
  }
  return outcome;
}

// What a least-squares pose is worth: by how much its lengths miss, and whether any tensions hold it.
Status leastSquaresVerdict(const RobotDescription& robot, const RobotSolution& solution, const Wrench& external,
                           double tolerance) {
  std::size_t worst = 0;
  double share = 0.0;
  for (std::size_t i = 0; i < solution.cables.size(); ++i) {
    const CableSolution& cable = solution.cables[i].cable;
    if (cable.closure_residual <= share * cable.length) continue;
    share = cable.closure_residual / cable.length;
    worst = i;
  }
  const std::string miss =
      text("the lengths contradict each other: at the pose that fits them best, that of cable '",
           solution.cables[worst].name, "' misses by ", solution.cables[worst].cable.closure_residual, " m");
  if (!(share <= kLargestMiss)) {
    return {Code::kInfeasible, miss +
                                   ", more than inextensible cables can explain: check lengths, anchors and "
                                   "attachments"};
  }
  if (!balanceVerdict(robot, solution, external, tolerance).ok()) {
    return {Code::kInfeasible,
            text(share > kAgreement ? miss + "; there " : "at the pose that fits the lengths ",
                 "no tensions of pulling cables balance the platform: ", solution.report.force_residual, " N and ",
                 solution.report.moment_residual, " N m are left over. STRAIGHT_ELASTIC finds the pose that balances")};
  }
  return {Code::kConverged, share > kAgreement ? miss + " (least squares)" : ""};
}

// The lines at the pose that was found, under the tensions of the springs or under those given; and how the platform
// resists, where they lead around pulleys or have dead lengths.
std::vector<CableSolution> describeLines(const RobotDescription& robot, const ForwardRequest& request,
                                         const RobotSolverOptions& options, Clock::time_point deadline,
                                         const Pose& pose, const std::vector<double>& tensions,
                                         std::vector<Spring>* given, LinearRobot* linear) {
  std::vector<Spring>& springs = *given;
  linear->start(pose);
  std::vector<CableSolution> cables;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], pose);
    const CableProperties& properties = robot.cables[i].properties;
    const StraightRope rope = straightRope(properties, plane.x, plane.y);
    const double tension = tensions.empty() ? springs[i].tension(rope.length()) : tensions[i];
    springs[i].held = tensions.empty() ? springs[i].held : rope.wrapped;
    const double half_weight = springs[i].halfWeight(properties);
    SaggingCable line(properties, options.model, options.tolerance);
    const bool started = options.model == Model::kStraightElastic && !beginsAtEyelet(properties) &&
                         line.startBetween(request.lengths[i], plane.x, plane.y, {options.tolerance, deadline}).ok();
    if (!started) {
      line.start(request.lengths[i],
                 {tension * rope.free.x() / rope.chord(), half_weight - tension * rope.free.y() / rope.chord()});
      if (!beginsAtEyelet(properties)) line.linearise(false);
    }
    CableSolution cable = line.describe(plane.x, plane.y, options.profile_points);
    if (!tensions.empty()) cable.closure_residual = std::abs(rope.length() - request.lengths[i]);
    cables.push_back(cable);
    const bool is_taut = tension > 0.0 && !beginsAtEyelet(properties);
    const Eigen::Matrix2d stiffness =
        is_taut ? Eigen::Matrix2d(forcesAtB(line) * cable.force_jacobian.leftCols<2>()) : Eigen::Matrix2d::Zero();
    linear->add(plane, stiffness, cable.horizontal_force,
                forceAtB(plane, cable.horizontal_force, cable.vertical_force_b));
  }
  return cables;
}

}  // namespace

RobotSolution solveStraightForward(const RobotDescription& robot, const ForwardRequest& request,
                                   const RobotSolverOptions& options, Clock::time_point deadline) {
  RobotSolution solution;
  solution.pose = request.seed.value_or(robot.home);
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    springs.push_back(springOf(robot.cables[i].properties, request.lengths[i]));
  }
  std::vector<double> tensions;
  SearchOutcome outcome;
  if (options.model == Model::kStraightElastic) {
    outcome = solveElastic(robot, request, options.tolerance, deadline, &springs, &solution.pose);
  } else if (static_cast<int>(robot.cables.size()) > robot.freedoms()) {
    outcome = solveOverdetermined(robot, request, options.tolerance, deadline, &solution.pose, &tensions);
  } else {
    outcome = solveInextensible(robot, request, options.tolerance, deadline, &springs, &solution.pose);
  }
  if (outcome.ok()) {
    if (const Status reach = checkPulleys(robot, solution.pose); !reach.ok()) outcome.status = reach;
  }
  if (!outcome.ok()) return failedRobot(options.model, outcome);

  LinearRobot linear(robot);
  const std::vector<CableSolution> cables =
      describeLines(robot, request, options, deadline, solution.pose, tensions, &springs, &linear);
  assemble(robot, request.external_wrench, cables, &solution);
  solution.report.iterations = outcome.iterations;
  Status verdict;
  if (tensions.empty()) {
    const bool plain = std::all_of(robot.cables.begin(), robot.cables.end(),
                                   [](const CableDescription& cable) { return beginsAtEyelet(cable.properties); });
    const Eigen::Matrix<double, 6, 6> resists =
        plain || options.model == Model::kStraight
            ? SpringPlatform(robot, &request.external_wrench).at(solution.pose, springs).stiffness
            : linear.stiffness();
    if (options.compute_stiffness) solution.stiffness = resists;
    double stiffness = 0.0;
    for (const Spring& spring : springs) stiffness += spring.stiffness;
    verdict = verdictOf(robot, solution, request.external_wrench, options.tolerance,
                        SpringPlatform::kSettled * options.tolerance * robot.span() * stiffness);
    if (verdict.ok()) verdict = describeStability(robot, platformStability(robot, resists));
  } else {
    verdict = leastSquaresVerdict(robot, solution, request.external_wrench, options.tolerance);
  }
  solution.report.status = verdict;
  if (verdict.ok() || verdict.code == Code::kUnstable) return solution;
  return failedRobot(options.model, outcomeOf(solution.report));
}

}  // namespace cdpr_kinetostatics
