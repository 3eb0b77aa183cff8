// What all services have in common: every call is answered, with a code and finite numbers.
#pragma once

#include <geometry_msgs/Pose.h>

#include <exception>
#include <vector>

#include "cdpr_kinetostatics/CableState.h"
#include "cdpr_kinetostatics/SolveReport.h"
#include "ros/request_checks.h"

namespace cdpr_kinetostatics {

bool allFinite(double value);
bool allFinite(const std::vector<double>& values);
bool allFinite(const SolveReport& report);
bool allFinite(const geometry_msgs::Pose& pose);
bool allFinite(const CableState& state);
bool allFinite(const std::vector<CableState>& states);

SolveReport failure(Code code, const std::string& message);

// Replaces `response` by what `solve` returns; if that throws, the response keeps its numbers and its report says why.
// `solve` checks the request, calls the core and converts the answer.
template <typename Response, typename Solve>
void reply(Response& response, const Solve& solve) {
  try {
    response = solve();
  } catch (const RequestError& problem) {
    response.report = failure(problem.code(), problem.what());
  } catch (const std::exception& problem) {
    response.report = failure(Code::kInternalError, problem.what());
  }
}

// Called by `solve` last: a number that is not finite is a defect, which must not leave the node.
template <typename... Parts>
void requireFinite(const Parts&... parts) {
  if (!(allFinite(parts) && ...)) {
    throw std::runtime_error("the solver returned a number that is not finite; please report this request");
  }
}

}  // namespace cdpr_kinetostatics
