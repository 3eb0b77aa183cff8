// Asks for all three problems of a cable, cold, and judges each answer by the independent check (collocation.h).
#pragma once

#include <string>

#include "cdpr_kinetostatics/cable/report.h"
#include "extreme_cables.h"

namespace cdpr_kinetostatics {

enum class Outcome {
  kNotAsked,     // problems 1 and 3 take their forces from problem 2
  kSolved,       // verified
  kRefused,      // an honest code
  kInaccurate,   // on the right branch, off by more than the accuracy
  kWrongBranch,  // an equilibrium, not the one asked for
  kUnverified,   // the check does not find an equilibrium near the answer
};

const char* outcomeName(Outcome outcome);

struct Judged {
  Outcome outcome = Outcome::kNotAsked;
  Code code = Code::kUnset;
  std::string message;
  double time = 0.0;  // [s]
  int iterations = 0;
  double error = 0.0;  // end over length (1); forces (2) and tension (3) over the larger end tension
};

struct CableVerdict {
  Judged position, forces, length;  // problems 1, 2, 3
  Judged single;                    // problem 2 by single shooting
  bool hinted = false;              // problem 3 was given a hint of the length
  double h = 0.0, v = 0.0;          // verified [N]
};

struct JudgeOptions {
  double tolerance = 1e-8;
  double timeout = 1.0;    // [s] per solve
  double accuracy = 1e-6;  // that error must not exceed
  bool hinted = false;
};

CableVerdict judge(const ExtremeCable& cable, const JudgeOptions& options);

}  // namespace cdpr_kinetostatics
