// Inverse kinetostatics with a free attitude, where the attitude asked for is too far from the one that holds.
#include <array>
#include <cmath>
#include <sstream>

#include "robot/basin_search.h"
#include "robot/inverse_solve.h"

namespace cdpr_kinetostatics {
namespace {

// An unstable platform is pushed over by this much before it falls.
constexpr double kPush = 0.2;  // [rad]

// Shortest step on the way from home, as a share of the way.
constexpr double kShortestStep = 1.0 / 64.0;

// How far the attitude on the way is iterated.
constexpr double kRough = 1e-3;

// Attitudes to start from where nothing else leads to an answer: tilted from the one asked for about four horizontal
// axes, and upside down.
std::vector<Eigen::Quaterniond> otherAttitudes(const Eigen::Quaterniond& asked) {
  std::vector<Eigen::Quaterniond> attitudes;
  for (const double angle : {0.6, -0.6, 1.2, -1.2, 3.0}) {
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(0.0, 1.0, 0.0)}) {
      attitudes.emplace_back(Eigen::AngleAxisd(angle, axis) * asked);
    }
  }
  return attitudes;
}

}  // namespace

std::optional<Eigen::Quaterniond> InverseSolve::attitudeAfterFall() {
  const PlatformStability stability = platformStability(robot_, stiffness());
  if (stability.motions.empty()) return std::nullopt;
  const Eigen::Vector3d turn = stability.motions.front().tail<3>();
  if (!(turn.norm() > 0.0)) return std::nullopt;
  RobotForces fallen = iteration_.reached();
  fallen.pose = displaced(fallen.pose, Eigen::Vector3d::Zero(), kPush * turn.normalized());
  const SearchOutcome outcome = roughStart(robot_, request_.external_wrench, fallen.lengths, deadline_, &fallen);
  outcome_.iterations += outcome.iterations;
  if (!outcome.ok()) return std::nullopt;
  return fallen.pose.orientation;
}

std::optional<Eigen::Quaterniond> InverseSolve::attitudeFromHome() {
  const InverseRequest asked = request_;
  const Eigen::Vector3d way = asked.pose.position - robot_.home.position;
  Eigen::Quaterniond attitude = robot_.home.orientation;
  double reached = 0.0;
  double step = 0.0;
  bool arrived = false;
  while (!arrived && !isLate()) {
    const double next = std::min(1.0, reached + step);
    request_.pose.position = robot_.home.position + next * way;
    iteration_.begin(request_);
    iteration_.setAttitude(attitude);
    const bool ok =
        iteration_.startCables(startingRung(options_.model), options_.tolerance).ok() && iterate(kRough).ok();
    if (ok) {
      attitude = iteration_.pose().orientation;
      arrived = next == 1.0;
      step = reached == next ? 1.0 : 2.0 * step;
      reached = next;
    } else {
      step *= 0.5;
      if (step < kShortestStep) break;
    }
  }
  request_ = asked;
  if (!arrived) return std::nullopt;
  return attitude;
}

Status InverseSolve::searchAttitudes(const Status& first) {
  Status answer = first;
  std::optional<Eigen::Quaterniond> unstable;
  int attempts = 1;
  // An unstable attitude far from the one asked for is no answer.
  const auto tryFrom = [&](const Eigen::Quaterniond& attitude, bool far) {
    ++attempts;
    const Status status = attempt(attitude);
    if (status.code == Code::kUnstable && !unstable && !far) unstable = iteration_.pose().orientation;
    if (status.ok()) answer = status;
    return status.ok();
  };
  if (first.code == Code::kUnstable) {
    unstable = iteration_.pose().orientation;
    const std::optional<Eigen::Quaterniond> fallen = attitudeAfterFall();
    if (fallen && tryFrom(*fallen, true)) return answer;
  }
  const std::optional<Eigen::Quaterniond> carried = attitudeFromHome();
  if (carried && tryFrom(*carried, false)) return answer;
  for (const Eigen::Quaterniond& attitude : otherAttitudes(request_.pose.orientation)) {
    if (isLate()) break;
    if (tryFrom(attitude, true)) return answer;
  }
  if (unstable) {
    // It has been found before, within the time allowed.
    deadline_ = Clock::time_point::max();
    return attempt(*unstable);
  }
  std::ostringstream text;
  text << "no attitude was found that holds this position, from " << attempts
       << " starting attitudes; from the one asked for: " << first.message;
  return {isLate() ? Code::kTimedOut : first.code, text.str()};
}

}  // namespace cdpr_kinetostatics
