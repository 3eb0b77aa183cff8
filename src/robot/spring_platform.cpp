#include "robot/spring_platform.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "cable/rope_on_pulley.h"
#include "robot/platform_stability.h"
#include "robot/platform_statics.h"
#include "robot/straight_rope.h"

namespace cdpr_kinetostatics {
namespace {

using Clock = std::chrono::steady_clock;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kMaxIterations = 500;

// A rope is never shorter than this share of its length: its direction stays a number.
constexpr double kLeastChord = 1e-12;

// Strain of the softest springs under the load, and how much stiffer the next ones are.
constexpr double kSoftStrain = 0.01;
constexpr double kStiffening = 10.0;
constexpr double kSoftTolerance = 1e-3;

// Rounding of the energy, relative to the sum of its terms.
constexpr double kEnergyRounding = 1e-14;

// A step is taken if the energy falls by this share of what the wrench along it promises (Armijo's condition).
constexpr double kLeastGain = 1e-4;

// Smallest damping, relative to the Hessian's largest entry; each refused step multiplies the damping by ten.
constexpr double kLeastDamping = 1e-9;

// Largest step of the platform: a share of the robot's span, and an angle.
constexpr double kMaxShareOfSpan = 0.2;
constexpr double kMaxRotation = 0.5;  // [rad]

// A saddle is left by this share of the span, or by this turn of the lever, or by a tenth of it, and so on, if the
// energy falls there.
constexpr double kEscape = 0.1;
constexpr double kShortestEscape = 1e-5;

// Makes moments comparable with forces.
Wrench forceScale(const RobotDescription& robot) {
  Wrench scale;
  scale << Eigen::Vector3d::Ones(), Eigen::Vector3d::Constant(robot.freedoms() == 6 ? 1.0 / robot.lever() : 1.0);
  return scale;
}

}  // namespace

double Spring::tension(double way) const {
  const double t = shift + stiffness * (way - length);
  return two_sided ? t : std::max(t, 0.0);
}

Spring springOf(const CableProperties& cable, double length) {
  return {cable.axial_stiffness / (length + cable.dead_length), length};
}

SpringWay springWay(const CableDescription& cable, const Pose& pose, double least_chord) {
  SpringWay way;
  if (!hasPulley(cable.properties)) {
    const Eigen::Vector3d along = anchorToAttachment(cable, pose);
    way.length = way.chord = std::max(along.norm(), least_chord);
    way.unit = along / way.chord;
    return way;
  }
  const CablePlane plane = cablePlane(cable, pose);
  const StraightRope rope = straightRope(cable.properties, plane.x, plane.y);
  way.chord = std::max(rope.chord(), least_chord);
  way.length = rope.wrapped + way.chord;
  way.unit = (rope.free.x() * plane.direction + rope.free.y() * Eigen::Vector3d::UnitZ()) / way.chord;
  // The pulley swivels about the vertical through the anchor, not about where the rope leaves.
  way.side = plane.side();
  if (plane.x > least_chord) way.across = rope.free.x() / way.chord / plane.x - 1.0 / way.chord;
  return way;
}

SpringPlatform::Local SpringPlatform::at(const Pose& pose, const std::vector<Spring>& springs) const {
  Local local;
  if (external_ != nullptr) {
    local.wrench = loadWrench(robot_, pose, *external_);
    local.stiffness = weightStiffness(robot_, pose);
    local.energy = robot_.weight() * pose.transform(robot_.com).z() - external_->head<3>().dot(pose.position);
  }
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const CableDescription& cable = robot_.cables[i];
    const Eigen::Vector3d arm = pose.orientation * cable.attachment;
    const SpringWay way = springWay(cable, pose, kLeastChord * springs[i].length);
    const Eigen::Vector3d& unit = way.unit;
    const double tension = springs[i].tension(way.length);
    Eigen::Vector3d force = -tension * unit;
    Eigen::Matrix3d by_b = -tension / way.chord * (Eigen::Matrix3d::Identity() - unit * unit.transpose());
    if (way.across != 0.0) by_b -= tension * way.across * way.side * way.side.transpose();
    if (tension > 0.0 || springs[i].two_sided) by_b -= springs[i].stiffness * unit * unit.transpose();
    local.energy += 0.5 * tension * tension / springs[i].stiffness;
    if (external_ != nullptr) {
      const double half_weight = springs[i].halfWeight(cable.properties);
      force.z() -= half_weight;
      local.energy += half_weight * anchorToAttachment(cable, pose).z();
    }
    local.wrench += wrenchAt(arm, force);
    local.stiffness += wrenchByMotion(arm, force, by_b * motionOfPoint(arm));
  }
  return local;
}

struct SpringPlatform::Move {
  Wrench step = Wrench::Zero();  // translation [m] and rotation vector [rad]
  // Of the whole step of Newton's method, before it is cut.
  double translation = 0.0;  // share of the robot's span
  double rotation = 0.0;     // [rad]
};

SearchOutcome SpringPlatform::descend(const std::vector<Spring>& springs, double tolerance, Clock::time_point deadline,
                                      Pose* pose) const {
  int iterations = 0;
  if (external_ != nullptr) {
    double stiffest = 0.0;
    for (const Spring& spring : springs) stiffest = std::max(stiffest, spring.stiffness * spring.length);
    const double load = std::max(robot_.weight(), external_->head<3>().norm());
    for (double soft = load / kSoftStrain; soft < stiffest; soft *= kStiffening) {
      std::vector<Spring> softened = springs;
      for (Spring& spring : softened) spring.stiffness = std::min(spring.stiffness, soft / spring.length);
      SearchOutcome outcome = newton(softened, std::max(tolerance, kSoftTolerance), deadline, pose);
      iterations += outcome.iterations;
      if (outcome.status.code != Code::kTimedOut) continue;
      outcome.iterations = iterations;
      return outcome;
    }
  }
  SearchOutcome outcome = newton(springs, tolerance, deadline, pose);
  outcome.iterations += iterations;
  return outcome;
}

bool SpringPlatform::step(const Local& here, double damping, Move* move) const {
  const int n = robot_.freedoms();
  const Wrench scale = forceScale(robot_);
  const Matrix6 hessian =
      -0.5 * scale.asDiagonal() * (here.stiffness + here.stiffness.transpose()).eval() * scale.asDiagonal();
  // All springs may be slack: the platform then falls, as far as a step may take it.
  const double size =
      std::max(hessian.topLeftCorner(n, n).diagonal().cwiseAbs().maxCoeff(), robot_.weight() / robot_.span());
  const Eigen::LLT<Eigen::MatrixXd> cholesky(hessian.topLeftCorner(n, n) +
                                             damping * size * Eigen::MatrixXd::Identity(n, n));
  if (cholesky.info() != Eigen::Success) return false;
  move->step.setZero();
  move->step.head(n) = cholesky.solve((scale.asDiagonal() * here.wrench).head(n));
  move->step = scale.asDiagonal() * move->step;
  move->translation = move->step.head<3>().norm() / robot_.span();
  move->rotation = move->step.tail<3>().norm();
  move->step *= std::min({1.0, kMaxShareOfSpan / move->translation, kMaxRotation / move->rotation});
  return true;
}

SearchOutcome SpringPlatform::newton(const std::vector<Spring>& springs, double tolerance, Clock::time_point deadline,
                                     Pose* pose) const {
  const int n = robot_.freedoms();
  const Wrench scale = forceScale(robot_);
  SearchOutcome outcome;
  const auto ended = [&](const Local& at, const Status& status) {
    outcome.status = status;
    outcome.residuals = residuals(at);
    return outcome;
  };
  Local here = at(*pose, springs);
  double damping = 0.0;
  for (int i = 0; i < kMaxIterations; ++i) {
    if (Clock::now() > deadline)
      return ended(here, {Code::kTimedOut, "the time allowed ran out while looking for the pose"});
    ++outcome.iterations;
    Move move;
    if (!step(here, damping, &move)) {
      damping = std::max(10.0 * damping, kLeastDamping);
      continue;
    }
    const Pose moved = displaced(*pose, move.step.head<3>(), move.step.tail<3>());
    const Local there = at(moved, springs);
    const double gained = gain(here, there, move.step.tail<3>());
    const bool tiny = move.translation < kSettled * tolerance && move.rotation < kSettled * tolerance;
    // Below the energy's rounding the wrench decides, and where it no longer falls the pose is found.
    const double promised = here.wrench.dot(move.step);
    const bool at_rounding = tiny || promised < rounding(here);
    const bool calmer =
        (scale.asDiagonal() * there.wrench).head(n).norm() < (scale.asDiagonal() * here.wrench).head(n).norm();
    if (at_rounding ? calmer : gained >= kLeastGain * promised) {
      *pose = moved;
      here = there;
      damping *= damping < kLeastDamping ? 0.0 : 0.1;
      if (tiny && damping == 0.0) return ended(here, {Code::kConverged, ""});
    } else if (at_rounding) {
      if (!leaveSaddle(springs, &here, pose)) return ended(here, {Code::kConverged, ""});
    } else {
      damping = std::max(10.0 * damping, kLeastDamping);
    }
  }
  return ended(here, {Code::kNotConverged, "no stable pose was found with straight cables of these lengths"});
}

double SpringPlatform::gain(const Local& here, const Local& there, const Eigen::Vector3d& turn) const {
  const double work = external_ != nullptr ? external_->tail<3>().dot(turn) : 0.0;
  return here.energy - there.energy + work;
}

double SpringPlatform::rounding(const Local& here) const {
  return kEnergyRounding * (std::abs(here.energy) + robot_.weight() * robot_.span());
}

bool SpringPlatform::leaveSaddle(const std::vector<Spring>& springs, Local* here, Pose* pose) const {
  const PlatformStability stability = platformStability(robot_, here->stiffness);
  if (stability.kind != Stability::kUnstable) return false;
  const Wrench motion = (robot_.freedoms() == 6 ? robot_.lever() : robot_.span()) * stability.motions.front();
  for (double size = kEscape; size > kShortestEscape; size *= 0.1) {
    for (const double sign : {1.0, -1.0}) {
      const Wrench step = sign * size * motion;
      const Pose moved = displaced(*pose, step.head<3>(), step.tail<3>());
      const Local there = at(moved, springs);
      if (!(gain(*here, there, step.tail<3>()) > rounding(*here))) continue;
      *pose = moved;
      *here = there;
      return true;
    }
  }
  return false;
}

Residuals SpringPlatform::residuals(const Local& here) const {
  return {0.0, here.wrench.head<3>().norm(), robot_.freedoms() == 6 ? here.wrench.tail<3>().norm() : 0.0};
}

}  // namespace cdpr_kinetostatics
