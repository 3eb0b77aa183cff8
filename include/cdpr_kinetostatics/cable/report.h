// What a solver says about how it ended.
//
// Not converging is a status, never an exception: every solve returns a code and, when it is not
// CONVERGED, a sentence that tells the user what to do. The numbers are those of SolveReport.msg.
#pragma once

#include <string>

namespace cdpr_kinetostatics {

enum class Code {
  kUnset = 0,
  kConverged = 1,
  kNotConverged = -1,
  kTimedOut = -2,
  kInvalidInput = -3,
  kInfeasible = -4,  // no tensions within the limits, or out of reach
  kWrongBranch = -5,
  kUnknownCable = -6,
  kUnstable = -8,  // an equilibrium that the platform would leave
  kInternalError = -99,
};

struct Status {
  Code code = Code::kUnset;
  std::string message;

  bool ok() const { return code == Code::kConverged; }
};

}  // namespace cdpr_kinetostatics
