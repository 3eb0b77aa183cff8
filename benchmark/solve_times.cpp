// Times of this package's solvers for scripts/studies/compare_scipy.py (docs/performance.md, item 6).
//
//     solve_times cables                  from lines "EA EI q L x y" of the input; prints CSV
//     solve_times robot FILE dx dy dz     home displaced by (dx, dy, dz) [m], found again from home, cold (from the
//                                         pose alone) and warm (from the solution there); prints JSON
#include <cmath>
#include <cstring>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/forward_follower.h"
#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "robot_cases.h"
#include "timing/timing.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kRounds = 51;

void requireOk(const Status& status) {
  if (!status.ok()) throw std::runtime_error(status.message);
}

void timeCables() {
  std::cout << "case,tolerance,h,v,angle_a,angle_b,seconds,catenary_h,catenary_v\n";
  CableProperties cable;
  double length = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (int i = 0; std::cin >> cable.axial_stiffness >> cable.bending_stiffness >> cable.weight >> length >> x >> y;
       ++i) {
    CableSolverOptions options;
    options.model = Model::kCatenary;
    const CableSolution catenary = findForces(cable, length, x, y, options);
    requireOk(catenary.status);
    options.model = Model::kBending;
    for (int digits = 3; digits <= 12; ++digits) {
      options.tolerance = std::pow(10.0, -digits);
      CableSolution solution;
      std::vector<double> times;
      for (int round = 0; round < kRounds; ++round) {
        const double begin = now();
        solution = findForces(cable, length, x, y, options);
        times.push_back(now() - begin);
      }
      requireOk(solution.status);
      std::cout << i << "," << options.tolerance << "," << solution.horizontal_force << "," << solution.vertical_force_a
                << "," << solution.angle_a << "," << solution.angle_b << "," << quantile(times, 0.5) << ","
                << catenary.horizontal_force << "," << catenary.vertical_force_a << "\n";
    }
  }
}

void printVector(const Eigen::Vector3d& v) { std::cout << "[" << v.x() << ", " << v.y() << ", " << v.z() << "]"; }

void printPose(const char* name, const Pose& pose) {
  const Eigen::Vector4d q = pose.orientation.coeffs();
  std::cout << "\"" << name << "\": {\"position\": ";
  printVector(pose.position);
  std::cout << ", \"orientation\": [" << q.x() << ", " << q.y() << ", " << q.z() << ", " << q.w() << "]}";
}

void requireFound(const RobotSolution& found, const Pose& pose) {
  requireOk(found.report.status);
  if (!samePose(found.pose, pose, 1e-6)) throw std::runtime_error("the forward solve led to another pose");
}

void timeRobot(const std::string& file, const Eigen::Vector3d& displacement) {
  const RobotDescription robot = loadRobotFile(file).robot;
  Pose pose = robot.home;
  const RobotSolution home = solveInverse(robot, requestFor(robot, pose), patient(Model::kBending, 1e-12));
  requireOk(home.report.status);
  pose.position += displacement;
  const RobotSolution there = solveInverse(robot, requestFor(robot, pose), patient(Model::kBending, 1e-12));
  requireOk(there.report.status);
  ForwardRequest at_home;
  at_home.lengths = lengthsOf(home);
  at_home.seed = home.pose;
  ForwardRequest request = at_home;
  request.lengths = lengthsOf(there);
  ForwardFollower follower(robot, patient(Model::kBending));
  std::vector<double> cold, warm;
  for (int round = 0; round < kRounds; ++round) {
    double begin = now();
    const RobotSolution found = solveForward(robot, request, patient(Model::kBending));
    cold.push_back(now() - begin);
    requireFound(found, there.pose);
    requireOk(follower.solve(at_home));
    begin = now();
    requireOk(follower.solve(request));
    warm.push_back(now() - begin);
    if (!follower.warmStarted()) throw std::runtime_error("the step is too long for a warm start");
  }
  const RobotSolution found = follower.solution();
  requireFound(found, there.pose);

  std::cout << "{\"name\": \"" << robot.name << "\", \"cold_seconds\": " << quantile(cold, 0.5)
            << ", \"warm_seconds\": " << quantile(warm, 0.5) << ", \"weight\": " << robot.weight()
            << ", \"freedoms\": " << robot.freedoms() << ", \"com\": ";
  printVector(robot.com);
  std::cout << ",\n ";
  printPose("start", home.pose);
  std::cout << ",\n ";
  printPose("pose", there.pose);
  std::cout << ",\n ";
  printPose("found", found.pose);
  std::cout << ",\n \"cables\": [";
  for (std::size_t i = 0; i < robot.cables.size(); ++i) {
    const CableDescription& cable = robot.cables[i];
    std::cout << (i == 0 ? "\n  " : ",\n  ") << "{\"anchor\": ";
    printVector(cable.anchor);
    std::cout << ", \"attachment\": ";
    printVector(cable.attachment);
    std::cout << ", \"properties\": [" << cable.properties.axial_stiffness << ", " << cable.properties.bending_stiffness
              << ", " << cable.properties.weight << "], \"length\": " << request.lengths[i]
              << ", \"start_length\": " << home.cables[i].cable.length << ", \"start_forces\": ["
              << home.cables[i].cable.horizontal_force << ", " << home.cables[i].cable.vertical_force_a << "]}";
  }
  std::cout << "]}\n";
}

}  // namespace
}  // namespace cdpr_kinetostatics

int main(int argc, char** argv) {
  using namespace cdpr_kinetostatics;
  std::cout << std::setprecision(17);
  try {
    if (argc == 2 && std::strcmp(argv[1], "cables") == 0) {
      timeCables();
    } else if (argc == 6 && std::strcmp(argv[1], "robot") == 0) {
      timeRobot(argv[2], {std::stod(argv[3]), std::stod(argv[4]), std::stod(argv[5])});
    } else {
      std::cerr << "usage: solve_times cables | robot FILE dx dy dz\n";
      return 2;
    }
  } catch (const std::exception& problem) {
    std::cerr << "solve_times: " << problem.what() << "\n";
    return 1;
  }
  return 0;
}
