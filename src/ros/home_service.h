// ~home.
#pragma once

#include <mutex>

#include "cdpr_kinetostatics/Home.h"
#include "ros/estimator_loop.h"

namespace cdpr_kinetostatics {

class HomeService {
 public:
  // Both must outlive the service.
  HomeService(EstimatorLoop& loop, const NodeParameters& parameters) : loop_(loop), parameters_(parameters) {}

  Home::Response serve(const Home::Request& request);

 private:
  Home::Response solve(const Home::Request& request);

  EstimatorLoop& loop_;
  const NodeParameters& parameters_;
  std::mutex busy_;
};

}  // namespace cdpr_kinetostatics
