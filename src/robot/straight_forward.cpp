#include "robot/straight_forward.h"

#include <algorithm>
#include <cmath>

#include "cable/sagging_cable.h"
#include "cable/text.h"
#include "cdpr_kinetostatics/robot/tension_distribution.h"
#include "robot/platform_stability.h"
#include "robot/platform_statics.h"
#include "robot/robot_gate.h"
#include "robot/solution_assembly.h"
#include "robot/spring_platform.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMaxMultiplierUpdates = 60;

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
    const Eigen::Vector3d along = anchorToAttachment(robot.cables[i], *pose);
    structure.col(static_cast<Eigen::Index>(i)) = wrenchAt(arm, -along.normalized());
    const double half_weight = 0.5 * robot.cables[i].properties.weight * request.lengths[i];
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
      const double chord = anchorToAttachment(robot.cables[k], *pose).norm();
      const double tension = spring.tension(chord);
      if (tension > 0.0) {
        excess = std::max(excess, std::abs(chord / spring.length - 1.0));
        open = std::max(open, std::abs(chord - spring.length));
      }
      spring.shift = tension;
    }
    outcome.residuals.closure = open;
    if (excess < kExcess) return outcome;
  }
  outcome.status = {Code::kNotConverged, "the inextensible cables' tensions did not settle"};
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

}  // namespace

RobotSolution solveStraightForward(const RobotDescription& robot, const ForwardRequest& request,
                                   const RobotSolverOptions& options, Clock::time_point deadline) {
  RobotSolution solution;
  solution.pose = request.seed.value_or(robot.home);
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    springs.push_back({robot.cables[i].properties.axial_stiffness / request.lengths[i], request.lengths[i]});
  }
  std::vector<double> tensions;
  SearchOutcome outcome;
  if (options.model == Model::kStraightElastic) {
    outcome =
        SpringPlatform(robot, &request.external_wrench).descend(springs, options.tolerance, deadline, &solution.pose);
  } else if (static_cast<int>(robot.cables.size()) > robot.freedoms()) {
    outcome = solveOverdetermined(robot, request, options.tolerance, deadline, &solution.pose, &tensions);
  } else {
    outcome = solveInextensible(robot, request, options.tolerance, deadline, &springs, &solution.pose);
  }
  if (!outcome.ok()) return failedRobot(options.model, outcome);

  std::vector<CableSolution> cables;
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CablePlane plane = cablePlane(robot.cables[i], solution.pose);
    const double chord = std::hypot(plane.x, plane.y);
    const double tension = tensions.empty() ? springs[i].tension(chord) : tensions[i];
    const double half_weight = 0.5 * robot.cables[i].properties.weight * request.lengths[i];
    SaggingCable line(robot.cables[i].properties, options.model, options.tolerance);
    line.start(request.lengths[i], {tension * plane.x / chord, half_weight - tension * plane.y / chord});
    CableSolution cable = line.describe(plane.x, plane.y, options.profile_points);
    if (!tensions.empty()) cable.closure_residual = std::abs(chord - request.lengths[i]);
    cables.push_back(cable);
  }
  assemble(robot, request.external_wrench, cables, &solution);
  solution.report.iterations = outcome.iterations;
  Status verdict;
  if (tensions.empty()) {
    const auto local = SpringPlatform(robot, &request.external_wrench).at(solution.pose, springs);
    if (options.compute_stiffness) solution.stiffness = local.stiffness;
    double stiffness = 0.0;
    for (const Spring& spring : springs) stiffness += spring.stiffness;
    verdict = verdictOf(robot, solution, request.external_wrench, options.tolerance,
                        SpringPlatform::kSettled * options.tolerance * robot.span() * stiffness);
    if (verdict.ok()) verdict = describeStability(robot, platformStability(robot, local.stiffness));
  } else {
    verdict = leastSquaresVerdict(robot, solution, request.external_wrench, options.tolerance);
  }
  solution.report.status = verdict;
  if (verdict.ok() || verdict.code == Code::kUnstable) return solution;
  return failedRobot(options.model, outcomeOf(solution.report));
}

}  // namespace cdpr_kinetostatics
