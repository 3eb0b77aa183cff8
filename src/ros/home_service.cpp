#include "ros/home_service.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>

#include "cable/text.h"
#include "estimation/homing.h"
#include "robot/offsets_file.h"
#include "ros/conversions.h"
#include "ros/request_checks.h"
#include "ros/service_reply.h"

namespace cdpr_kinetostatics {

namespace {

// Enough to average noise to a tenth, within some seconds at the rates of drives.
constexpr std::uint32_t kUsualSamples = 100;
constexpr std::uint32_t kMostSamples = 10000;
constexpr double kUsualWindow = 10.0;    // [s]
constexpr double kLongestWindow = 60.0;  // [s]

struct Window {
  std::size_t samples;
  std::chrono::duration<double> time;
};

Window checkedWindow(const Home::Request& request) {
  const double window = request.window.toSec();
  if (!(window >= 0.0 && window <= kLongestWindow)) {
    throw RequestError(text("window is ", window, " s: expected 0 for the default, or up to ", kLongestWindow, " s"));
  }
  if (request.samples != 0 && (request.samples < RestingSamples::kLeast || request.samples > kMostSamples)) {
    throw RequestError(text("samples is ", request.samples, ": expected 0 for the default, or ", RestingSamples::kLeast,
                            " to ", kMostSamples));
  }
  const std::uint32_t usual = window > 0.0 ? kMostSamples : kUsualSamples;
  return {request.samples != 0 ? request.samples : usual,
          std::chrono::duration<double>(window > 0.0 ? window : kUsualWindow)};
}

double largestMagnitude(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

Home::Response HomeService::serve(const Home::Request& request) {
  Home::Response response;
  response.applied = 0;
  reply(response, [&] { return solve(request); });
  return response;
}

Home::Response HomeService::solve(const Home::Request& request) {
  const auto start = std::chrono::steady_clock::now();
  HomingRequest homing_request;
  homing_request.pose = checkedPose("pose", request.pose);
  homing_request.use_tensions = request.use_tensions != 0;
  const Window window = checkedWindow(request);
  const std::unique_lock<std::mutex> one_at_a_time(busy_, std::try_to_lock);
  if (!one_at_a_time.owns_lock()) throw RequestError("another call of this service is still waiting: let it end");

  const RestingSamples samples = loop_.collect(window.samples, window.time);
  const Homing homing = findHome(parameters_.robot, parameters_.estimator, homing_request, samples);

  Home::Response response;
  response.applied = 0;
  response.report = toMsg(homing.report);
  if (homing.report.status.ok()) {
    response.offsets = loop_.correctOffsets(homing.corrections, homing.pose);
    response.stddev = homing.stddev;
    response.applied = 1;
    std::string& message = response.report.message;
    message =
        text("from ", samples.count(), " measurements: offsets changed by up to ", largestMagnitude(homing.corrections),
             " m, known to ", largestMagnitude(homing.stddev), " m if the platform is exactly at this pose");
    if (!parameters_.offsets_file.empty()) {
      try {
        writeOffsets(parameters_.offsets_file, parameters_.robot, response.offsets);
      } catch (const std::exception& problem) {
        message += text("; in use until the node ends, as ", problem.what());
        ROS_ERROR_STREAM("home: " << problem.what());
      }
    }
    ROS_INFO_STREAM("home: " << message);
  }
  response.report.solve_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  requireFinite(response.report, response.offsets, response.stddev);
  return response;
}

}  // namespace cdpr_kinetostatics
