// The program of tension_program.h with a free attitude: second derivatives by differences, limits that the turn moves.
#include <cmath>

#include "robot/platform_statics.h"
#include "robot/tension_program.h"

namespace cdpr_kinetostatics {
namespace {

// Step of the differences behind second derivatives [rad].
constexpr double kDifference = 1e-5;

// What a small turn changes in the wrench of a cable that is closed by force.
Eigen::Matrix<double, 6, 3> wrenchByTurn(const InverseCable& c, const Eigen::Vector3d& force) {
  const Eigen::Vector3d side = c.plane.side();
  const double h = c.cable.horizontalForce() + c.start.x();
  const double across = forceDensity(c.plane, h, c.by_end.topRows<2>());
  const Eigen::Matrix3d arm = cross(c.plane.arm);
  const Eigen::Matrix3d force_by_turn = c.forceByCable() * c.byTurn() + across * side * side.transpose() * arm;
  Eigen::Matrix<double, 6, 3> wrench;
  wrench << force_by_turn, arm * force_by_turn + cross(force) * arm;
  return wrench;
}

// First derivatives with respect to the pulls and the turn.
struct FirstOrder {
  Eigen::MatrixXd wrench;    // scaled
  Eigen::VectorXd gradient;  // of the objective
  Eigen::MatrixXd tension;   // of T_A, a row for each cable, by the turn
  Eigen::VectorXd slope;     // of T_A, by the pulls
};

FirstOrder firstOrder(const InverseProblem& problem, const Pose& pose, const std::vector<InverseCable>& cables) {
  const auto n = static_cast<Eigen::Index>(cables.size());
  const FreeAttitude::Axes axes = problem.attitude.axes(pose);
  FirstOrder first;
  first.wrench = Eigen::MatrixXd::Zero(6, n + axes.cols());
  first.gradient = Eigen::VectorXd::Zero(n + axes.cols());
  first.tension.resize(n, axes.cols());
  first.slope.resize(n);
  Eigen::Matrix<double, 6, 3> by_turn = weightStiffness(problem.robot, pose).rightCols<3>();
  for (Eigen::Index i = 0; i < n; ++i) {
    const InverseCable& c = cables[i];
    first.wrench.col(i) = wrenchAt(c.plane.arm, c.forceByCable() * c.by_pull);
    by_turn += wrenchByTurn(c, c.closedForce());
    first.tension.row(i) = c.tensionByTurn() * axes;
    first.slope(i) = c.slope;
    const double weight = problem.weight(static_cast<std::size_t>(i));
    const double push = weight * weight * (c.tension - problem.preferred(i));
    first.gradient(i) = push * c.slope;
    first.gradient.tail(axes.cols()) += push * first.tension.row(i).transpose();
  }
  first.wrench.rightCols(axes.cols()) = by_turn * axes;
  first.wrench.bottomRows<3>() /= problem.lever;
  return first;
}

// After a small turn, at constant pulls. False: a cable cannot be evaluated there.
bool turnCables(const InverseProblem& problem, const Pose& turned, const Eigen::Vector3d& turn,
                std::vector<InverseCable>* cables) {
  for (std::size_t i = 0; i < cables->size(); ++i) {
    InverseCable& c = (*cables)[i];
    c.cable.step(c.change(c.pull, turn), 1.0);
    if (!c.linearise(problem.robot.cables[i], turned, Steps::kKept, 0.0)) return false;
  }
  return true;
}

// How the pull at a limit of T_A moves with the turn: it keeps T_A, or at the fold the slope.
Eigen::RowVectorXd limitByTurn(const InverseCable& c, const Eigen::RowVectorXd& tension,
                               const Eigen::RowVectorXd& slope, bool fold) {
  if (fold) return c.curvature > 0.0 ? Eigen::RowVectorXd(-slope / c.curvature) : Eigen::RowVectorXd(0.0 * slope);
  return -tension / std::max(c.slope, 1e-3);
}

// Of the pulls, as the turn moves them, and of the turn itself.
void addLimits(const InverseProblem& problem, const Pose& pose, const std::vector<InverseCable>& cables,
               const FirstOrder& here, const Eigen::MatrixXd& slope_by_turn, QuadraticProgram* program) {
  const auto n = static_cast<Eigen::Index>(cables.size());
  const Eigen::Index turns = slope_by_turn.cols();
  program->normals = Eigen::MatrixXd::Zero(n + turns, 2 * n + 2 * turns);
  program->bounds.resize(2 * n + 2 * turns);
  program->scale = Eigen::VectorXd::Ones(n + turns);
  for (Eigen::Index i = 0; i < n; ++i) {
    const InverseCable& c = cables[i];
    program->scale(i) = 1.0 / problem.weight(static_cast<std::size_t>(i));
    program->normals(i, i) = 1.0;
    program->normals.block(n, i, turns, 1) =
        -limitByTurn(c, here.tension.row(i), slope_by_turn.row(i), c.at_fold).transpose();
    program->bounds(i) = c.least - c.pull;
    program->normals(i, n + i) = -1.0;
    program->normals.block(n, n + i, turns, 1) =
        limitByTurn(c, here.tension.row(i), slope_by_turn.row(i), false).transpose();
    program->bounds(n + i) = c.pull - c.most;
  }
  const FreeAttitude::Turn least = problem.attitude.least(pose);
  const FreeAttitude::Turn most = problem.attitude.most(pose);
  for (Eigen::Index k = 0; k < turns; ++k) {
    program->normals(n + k, 2 * n + k) = 1.0;
    program->bounds(2 * n + k) = least(k);
    program->normals(n + k, 2 * n + turns + k) = -1.0;
    program->bounds(2 * n + turns + k) = -most(k);
  }
}

}  // namespace

std::optional<QuadraticProgram> attitudeProgram(const InverseProblem& problem, const Pose& pose,
                                                const std::vector<InverseCable>& cables,
                                                const Eigen::VectorXd& multipliers) {
  const auto n = static_cast<Eigen::Index>(cables.size());
  const FreeAttitude::Axes axes = problem.attitude.axes(pose);
  const Eigen::Index turns = axes.cols();
  const FirstOrder here = firstOrder(problem, pose, cables);
  QuadraticProgram program;
  program.matrix = here.wrench;
  program.right = -imbalance(problem, pose, cables);
  program.gradient = here.gradient;
  program.hessian = Eigen::MatrixXd::Zero(n + turns, n + turns);
  const bool weighed = multipliers.size() > 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const InverseCable& c = cables[i];
    const double weight = problem.weight(static_cast<std::size_t>(i));
    const double excess = c.tension - problem.preferred(i);
    program.hessian(i, i) = weight * weight * (c.slope * c.slope + excess * c.curvature);
    if (!weighed) continue;
    Wrench bend = wrenchAt(c.plane.arm, c.forceByCable() * c.bend);
    bend.tail<3>() /= problem.lever;
    program.hessian(i, i) -= multipliers.dot(bend);
  }
  Eigen::MatrixXd slope_by_turn(n, turns);
  for (Eigen::Index k = 0; k < turns; ++k) {
    FreeAttitude::Turn turn = FreeAttitude::Turn::Zero(turns);
    turn(k) = kDifference;
    std::vector<InverseCable> beside = cables;
    const Pose turned = problem.attitude.turned(pose, turn);
    if (!turnCables(problem, turned, axes * turn, &beside)) return std::nullopt;
    const FirstOrder there = firstOrder(problem, turned, beside);
    Eigen::VectorXd column = there.gradient - here.gradient;
    if (weighed) column -= (there.wrench - here.wrench).transpose() * multipliers;
    column /= kDifference;
    program.hessian.block(0, n + k, n, 1) = column.head(n);
    program.hessian.block(n + k, 0, 1, n) = column.head(n).transpose();
    program.hessian.block(n, n + k, turns, 1) += 0.5 * column.tail(turns);
    program.hessian.block(n + k, n, 1, turns) += 0.5 * column.tail(turns).transpose();
    slope_by_turn.col(k) = (there.slope - here.slope) / kDifference;
  }
  addLimits(problem, pose, cables, here, slope_by_turn, &program);
  return program;
}

}  // namespace cdpr_kinetostatics
