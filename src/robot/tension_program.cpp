#include "robot/tension_program.h"

#include <algorithm>
#include <cmath>

#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

// Share of its Gauss-Newton part that is left of a cable's curvature, at least, and of the square of a slope of 1:
// where T_A has its least value, and where the forces bend the other way.
constexpr double kLeastShare = 0.1;
constexpr double kLeastCurvature = 0.01;

Wrench scaleOf(const InverseProblem& problem) {
  Wrench scale = Wrench::Ones();
  scale.tail<3>().setConstant(1.0 / problem.lever);
  return scale;
}

}  // namespace

double objective(const InverseProblem& problem, const std::vector<InverseCable>& cables) {
  double sum = 0.0;
  for (std::size_t i = 0; i < cables.size(); ++i) {
    const double excess = problem.weight(i) * (cables[i].tension - problem.preferred(static_cast<Eigen::Index>(i)));
    sum += 0.5 * excess * excess;
  }
  return sum;
}

Eigen::VectorXd imbalance(const InverseProblem& problem, const Pose& pose, const std::vector<InverseCable>& cables) {
  Wrench total = loadWrench(problem.robot, pose, problem.external);
  for (const InverseCable& c : cables) total += wrenchAt(c.plane.arm, c.closedForce());
  return scaleOf(problem).cwiseProduct(total).head(problem.robot.freedoms());
}

TensionProblem tensionProgram(const InverseProblem& problem, const Pose& pose, const std::vector<InverseCable>& cables,
                              const Eigen::VectorXd& multipliers) {
  const auto n = static_cast<Eigen::Index>(cables.size());
  const int rows = problem.robot.freedoms();
  const Wrench scale = scaleOf(problem);
  Wrench total = loadWrench(problem.robot, pose, problem.external);
  TensionProblem program;
  program.matrix.resize(rows, n);
  program.preferred.resize(n);
  program.weight.resize(n);
  program.lower.resize(n);
  program.upper.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const InverseCable& c = cables[i];
    const Eigen::Matrix3d force_by_cable = c.forceByCable();
    const Wrench by_pull = wrenchAt(c.plane.arm, force_by_cable * c.by_pull);
    total += wrenchAt(c.plane.arm, c.force() + force_by_cable * c.start) - by_pull * c.pull;
    program.matrix.col(i) = scale.cwiseProduct(by_pull).head(rows);

    const double weight = problem.weight(static_cast<std::size_t>(i));
    const double excess = c.tension - problem.preferred(i);
    double curvature = c.slope * c.slope + excess * c.curvature;
    if (multipliers.size() > 0 && !c.bend.isZero(0.0)) {
      const Wrench bend = scale.cwiseProduct(wrenchAt(c.plane.arm, force_by_cable * c.bend));
      curvature -= multipliers.dot(bend.head(rows)) / (weight * weight);
    }
    curvature = std::max({std::abs(curvature), kLeastShare * c.slope * c.slope, kLeastCurvature});
    program.preferred(i) = c.pull - excess * c.slope / curvature;
    program.weight(i) = weight * std::sqrt(curvature);
    program.lower(i) = c.least;
    program.upper(i) = c.most;
  }
  program.wrench = -scale.cwiseProduct(total).head(rows);
  return program;
}

}  // namespace cdpr_kinetostatics
