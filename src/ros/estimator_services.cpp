#include "ros/estimator_services.h"

#include "cable/text.h"
#include "ros/request_checks.h"

namespace cdpr_kinetostatics {

SetPose::Response serveSetPose(EstimatorLoop& loop, const NodeParameters& parameters, const SetPose::Request& request) {
  SetPose::Response response;
  response.success = 0;
  const std::string& frame = request.pose.header.frame_id;
  if (!frame.empty() && frame != parameters.base_frame) {
    response.message = text("pose.header.frame_id is '", frame, "': expected '", parameters.base_frame, "', or none");
    return response;
  }
  try {
    loop.setPose(checkedPose("pose", request.pose.pose));
  } catch (const RequestError& problem) {
    response.message = problem.what();
    return response;
  }
  response.success = 1;
  response.message = "the next estimate starts there";
  return response;
}

std_srvs::Trigger::Response serveReset(EstimatorLoop& loop) {
  loop.reset();
  std_srvs::Trigger::Response response;
  response.success = 1;
  response.message = "the next estimate starts from the robot's home";
  return response;
}

}  // namespace cdpr_kinetostatics
