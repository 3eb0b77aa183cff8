#include "residuals/platform_measurements.h"

#include "geometry/spatial.h"

namespace cdpr_kinetostatics {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

// Residuals and their derivatives by (translation, rotation vector) and by the densities, filled from the top.
struct PlatformMeasurements::Rows {
  Eigen::Map<Eigen::VectorXd> residuals;
  RowMajor by_pose, by_density;
  Eigen::Index next = 0;
};

PlatformMeasurements::PlatformMeasurements(const Platform& platform, const std::vector<Cable>& cables,
                                           const Wrench& load_weight, const SolveLimits& limits)
    : platform_(platform), load_weight_(load_weight) {
  int rows = (load_weight.array() > 0.0).any() ? (platform.rigid_body ? 6 : 3) : 0;
  for (const Cable& cable : cables) {
    cables_.emplace_back(cable.anchor, cable.attachment, cable.start, limits);
    lengths_.push_back(cable.length);
    tensions_.push_back(cable.tension);
    rows += static_cast<int>(cable.length.has_value()) + static_cast<int>(cable.tension.has_value());
  }
  AddParameterBlock(3);
  AddParameterBlock(4);
  AddParameterBlock(static_cast<int>(cables.size()));
  SetNumResiduals(rows);
}

// Ceres asks for the Jacobian where it has just asked for the residuals: the cables are closed there already.
bool PlatformMeasurements::closeAll(double const* const* parameters) const {
  std::vector<double> at(parameters[0], parameters[0] + 3);
  at.insert(at.end(), parameters[1], parameters[1] + 4);
  at.insert(at.end(), parameters[2], parameters[2] + cables_.size());
  if (at == closed_at_) return true;
  closed_at_.clear();
  before_ = cables_;
  pose_ = {Eigen::Vector3d(parameters[0]), Eigen::Quaterniond(parameters[1])};
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    if (cables_[i].close(pose_, parameters[2][i])) continue;
    cables_ = before_;
    return false;
  }
  closed_at_ = at;
  return true;
}

LoadBalance PlatformMeasurements::loadBalance() const {
  const Eigen::Vector3d gravity(0.0, 0.0, -platform_.weight);
  const Eigen::Vector3d com = pose_.orientation * platform_.com;
  LoadBalance balance;
  balance.total = wrenchAt(com, gravity) + platform_.external_wrench;
  balance.by_pose = wrenchByMotion(com, gravity, Eigen::Matrix<double, 3, 6>::Zero());
  balance.by_density.resize(6, static_cast<Eigen::Index>(cables_.size()));
  Eigen::Index column = 0;
  for (const ClosedCable& cable : cables_) {
    const Eigen::Vector3d& arm = cable.plane().arm;
    const Eigen::Vector3d force = cable.force();
    balance.total += wrenchAt(arm, force);
    balance.by_pose += wrenchByMotion(arm, force, cable.forceByPose());
    balance.by_density.col(column++) = wrenchAt(arm, cable.forceByDensity());
  }
  return balance;
}

// Where the pose moves and the length stays, the density changes by -(dL/dpose)/(dL/ddensity).
Eigen::Matrix<double, 6, 6> PlatformMeasurements::stiffness(const LoadBalance& balance) const {
  Eigen::Matrix<double, 6, 6> stiffness = balance.by_pose;
  Eigen::Index column = 0;
  for (const ClosedCable& cable : cables_) {
    stiffness -= balance.by_density.col(column++) * cable.byPose().row(2) / cable.byDensity().z();
  }
  return stiffness;
}

void PlatformMeasurements::addLengths(Rows* rows) const {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    if (!lengths_[i]) continue;
    const double deviation = lengths_[i]->deviation;
    const ClosedCable& closed = cables_[i];
    rows->residuals(rows->next) = (closed.cable().length() - lengths_[i]->value) / deviation;
    rows->by_pose.row(rows->next) = closed.byPose().row(2) / deviation;
    rows->by_density(rows->next, static_cast<Eigen::Index>(i)) = closed.byDensity().z() / deviation;
    ++rows->next;
  }
}

void PlatformMeasurements::addTensions(Rows* rows) const {
  for (std::size_t i = 0; i < cables_.size(); ++i) {
    if (!tensions_[i]) continue;
    const double deviation = tensions_[i]->deviation;
    const SaggingCable& cable = cables_[i].cable();
    const double tension = cable.tensionA();
    const Eigen::RowVector2d by_force =
        Eigen::RowVector2d(cable.horizontalForce(), cable.verticalForceA()) / (tension * deviation);
    rows->residuals(rows->next) = (tension - tensions_[i]->value) / deviation;
    rows->by_pose.row(rows->next) = by_force * cables_[i].byPose().topRows<2>();
    rows->by_density(rows->next, static_cast<Eigen::Index>(i)) = by_force * cables_[i].byDensity().head<2>();
    ++rows->next;
  }
}

void PlatformMeasurements::addLoad(Rows* rows) const {
  const Eigen::Index count = rows->residuals.size() - rows->next;
  if (count == 0) return;
  const LoadBalance balance = loadBalance();
  rows->residuals.tail(count) = load_weight_.cwiseProduct(balance.total).head(count);
  rows->by_pose.bottomRows(count) = (load_weight_.asDiagonal() * balance.by_pose).topRows(count);
  rows->by_density.bottomRows(count) = (load_weight_.asDiagonal() * balance.by_density).topRows(count);
}

bool PlatformMeasurements::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  if (!closeAll(parameters)) return false;
  const int count = num_residuals();
  const auto n = static_cast<Eigen::Index>(cables_.size());
  Rows rows{Eigen::Map<Eigen::VectorXd>(residuals, count), RowMajor(count, 6), RowMajor::Zero(count, n)};
  addLengths(&rows);
  addTensions(&rows);
  addLoad(&rows);
  if (!rows.residuals.allFinite() || !rows.by_pose.allFinite() || !rows.by_density.allFinite()) return false;
  if (jacobians == nullptr) return true;
  if (jacobians[0] != nullptr) Eigen::Map<RowMajor>(jacobians[0], count, 3) = rows.by_pose.leftCols<3>();
  if (jacobians[1] != nullptr) {
    Eigen::Map<RowMajor>(jacobians[1], count, 4) =
        rows.by_pose.rightCols<3>() * rotationByQuaternion(pose_.orientation);
  }
  if (jacobians[2] != nullptr) Eigen::Map<RowMajor>(jacobians[2], count, n) = rows.by_density;
  return true;
}

}  // namespace cdpr_kinetostatics
