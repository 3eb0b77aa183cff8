// Is AUTO as accurate as it says? Random scenes of every shipped robot, against BENDING at a tolerance of 1e-11.
//   auto_honesty [--scenes N] [--csv FILE] [--quick]      N answers; scripts/studies/plot_auto.py draws them
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#include "robot_cases.h"

namespace {

using namespace cdpr_kinetostatics;

constexpr double kFinest = 1e-11;

double logUniform(Dice* dice, double low, double high) {
  return std::exp(dice->uniform(std::log(low), std::log(high)));
}

struct Outcome {
  bool solved = false;
  double truth = 0.0;           // [m]
  double estimate = 0.0;        // [m]
  int rungs[4] = {0, 0, 0, 0};  // straight_elastic, catenary, catenary_corrected, bending
  bool coarser() const { return rungs[0] + rungs[1] + rungs[2] > 0; }
};

void countRungs(const RobotSolution& solution, Outcome* outcome) {
  for (const CableResult& cable : solution.cables) {
    const Model model = cable.cable.model;
    ++outcome->rungs[model == Model::kBending ? 3 : model == Model::kCatenaryCorrected ? 2 : model == Model::kCatenary];
  }
}

// Poses across the workspace, tensions from slack to limit, EI over four decades, accuracies over four.
struct Scene {
  RobotDescription robot;
  InverseRequest request;
  double stiffness_factor = 1.0;
  double accuracy = 1e-4;
};

Scene randomScene(const Workspace& workspace, Dice* dice) {
  Scene scene;
  scene.robot = shippedRobot(ROBOT_DIR, workspace.robot);
  scene.stiffness_factor = logUniform(dice, 1e-2, 1e2);
  scene.accuracy = logUniform(dice, 1e-6, 1e-2);
  for (CableDescription& cable : scene.robot.cables) {
    cable.properties.bending_stiffness *= scene.stiffness_factor;
    cable.tension_min *= 0.05;
  }
  scene.request = requestFor(scene.robot, randomPose(workspace, dice));
  for (const CableDescription& cable : scene.robot.cables) {
    scene.request.preferred_tensions.push_back(
        logUniform(dice, std::max(cable.tension_min, 1e-3 * cable.tension_max), cable.tension_max));
  }
  return scene;
}

}  // namespace

int main(int argc, char** argv) {
  int scenes = 3500;
  std::string file;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--quick") {
      scenes = 70;
    } else if (argument == "--scenes" && i + 1 < argc) {
      scenes = std::stoi(argv[++i]);
    } else if (argument == "--csv" && i + 1 < argc) {
      file = argv[++i];
    } else {
      std::cerr << "usage: auto_honesty [--scenes N] [--csv FILE] [--quick]\n";
      return 2;
    }
  }
  std::ofstream csv(file);
  csv << "robot,problem,accuracy,stiffness_factor,straight_elastic,catenary,catenary_corrected,bending,truth,"
         "estimate\n";
  Dice dice(2024);
  const std::vector<Workspace> workspaces = shippedWorkspaces();
  int answers = 0, within = 0, beyond = 0, coarser = 0, honest = 0, refused = 0;
  for (int k = 0; answers < scenes; ++k) {
    const Workspace& workspace = workspaces[static_cast<std::size_t>(k) % workspaces.size()];
    const Scene scene = randomScene(workspace, &dice);
    const RobotSolution reference = solveInverse(scene.robot, scene.request, patient(Model::kBending, 1e-10));
    if (!reference.report.status.ok()) continue;
    const std::vector<double> lengths = lengthsOf(reference);
    const RobotSolution truth = forward(scene.robot, lengths, reference.pose, patient(Model::kBending, kFinest));
    // A pose that the platform leaves, for instance an unstable one, is no pose to compare at.
    if (!truth.report.status.ok() || !samePose(truth.pose, reference.pose, 1e-6)) continue;
    RobotSolverOptions options = patient(Model::kAuto);
    options.accuracy = scene.accuracy;

    for (const char* problem : {"forward", "inverse"}) {
      Outcome outcome;
      const bool is_forward = problem[0] == 'f';
      const RobotSolution found = is_forward ? forward(scene.robot, lengths, reference.pose, options)
                                             : solveInverse(scene.robot, scene.request, options);
      if (found.report.status.ok()) {
        const RobotSolution applied =
            is_forward ? truth : forward(scene.robot, lengthsOf(found), found.pose, patient(Model::kBending, kFinest));
        outcome.solved = applied.report.status.ok();
        outcome.truth = (found.pose.position - applied.pose.position).norm();
        outcome.estimate = found.report.estimated_error;
        countRungs(found, &outcome);
      }
      csv << workspace.robot << ',' << problem << ',' << scene.accuracy << ',' << scene.stiffness_factor;
      if (!outcome.solved) {
        ++refused;
        csv << ",,,,,,\n";
        std::printf("%s %s accuracy %.2e EI x %.2e: %s\n", workspace.robot.c_str(), problem, scene.accuracy,
                    scene.stiffness_factor, found.report.status.message.c_str());
        continue;
      }
      ++answers;
      within += outcome.truth <= scene.accuracy;
      beyond += outcome.truth > 3.0 * scene.accuracy;
      if (outcome.coarser()) {
        ++coarser;
        honest += outcome.estimate < 5.0 * outcome.truth && outcome.truth < 5.0 * outcome.estimate;
      }
      for (const int count : outcome.rungs) csv << ',' << count;
      csv << ',' << outcome.truth << ',' << outcome.estimate << '\n';
      if (outcome.truth > scene.accuracy) {
        std::printf("%s %s accuracy %.2e EI x %.2e: true error %.2e m, estimated %.2e m (%d %d %d %d)\n",
                    workspace.robot.c_str(), problem, scene.accuracy, scene.stiffness_factor, outcome.truth,
                    outcome.estimate, outcome.rungs[0], outcome.rungs[1], outcome.rungs[2], outcome.rungs[3]);
      }
    }
  }
  std::printf("answers %d, refused %d\n", answers, refused);
  std::printf("within the accuracy asked for: %.3f %%\n", 100.0 * within / answers);
  std::printf("beyond three times: %d\n", beyond);
  std::printf("estimate within a factor 5 of the truth where a coarser rung was used: %.2f %% of %d\n",
              100.0 * honest / std::max(coarser, 1), coarser);
  return 0;
}
