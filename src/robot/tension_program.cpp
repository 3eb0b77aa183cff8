#include "robot/tension_program.h"

#include "robot/platform_statics.h"

namespace cdpr_kinetostatics {
namespace {

// Largest turn of a free attitude in one iteration.
constexpr double kMaxTurn = 0.2;  // [rad]

// What a small turn changes in the wrench of a cable that is closed by force.
Eigen::Matrix<double, 6, 3> wrenchByTurn(const InverseCable& c, const Eigen::Vector3d& force) {
  const Eigen::Vector3d side = c.plane.side();
  const double h = c.cable.horizontalForce() + c.start.x();
  const double across = forceDensity(c.plane, h, c.by_end.topRows<2>());
  const Eigen::Matrix3d arm = cross(c.plane.arm);
  const Eigen::Matrix3d force_by_turn = c.forceByCable() * c.by_turn + across * side * side.transpose() * arm;
  Eigen::Matrix<double, 6, 3> wrench;
  wrench << force_by_turn, arm * force_by_turn + cross(force) * arm;
  return wrench;
}

}  // namespace

TensionProblem tensionProgram(const RobotDescription& robot, const Pose& pose, const Wrench& external,
                              const std::vector<InverseCable>& cables, const Eigen::VectorXd& preferred,
                              const FreeTurn& turn) {
  const auto n = static_cast<Eigen::Index>(cables.size());
  const int rows = robot.freedoms();
  const Eigen::Index variables = n + (turn.free ? 3 : 0);
  Wrench scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(1.0 / robot.lever());

  Wrench total = loadWrench(robot, pose, external);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, variables);
  if (turn.free) matrix.rightCols<3>() = weightStiffness(robot, pose).rightCols<3>();
  TensionProblem problem;
  problem.preferred = Eigen::VectorXd::Zero(variables);
  problem.weight = Eigen::VectorXd::Constant(variables, turn.weight);
  problem.lower = Eigen::VectorXd::Constant(variables, -kMaxTurn);
  problem.upper = Eigen::VectorXd::Constant(variables, kMaxTurn);
  for (Eigen::Index i = 0; i < n; ++i) {
    const InverseCable& c = cables[i];
    const Eigen::Matrix3d force_by_cable = c.forceByCable();
    const Eigen::Vector3d force = c.force() + force_by_cable * c.start;
    matrix.col(i) = wrenchAt(c.plane.arm, force_by_cable * c.by_tension);
    total += wrenchAt(c.plane.arm, force) - matrix.col(i) * c.cable.tensionA();
    if (turn.free) matrix.rightCols<3>() += wrenchByTurn(c, force);
    problem.preferred(i) = preferred(i);
    problem.weight(i) = 1.0 / (robot.cables[i].tension_max - robot.cables[i].tension_min);
    problem.lower(i) = c.lower;
    problem.upper(i) = c.upper;
  }
  problem.matrix = (scale.asDiagonal() * matrix).topRows(rows);
  problem.wrench = -(scale.asDiagonal() * total).head(rows);
  return problem;
}

}  // namespace cdpr_kinetostatics
