// Whatever numbers a request holds, it is answered in time, with a code, a sentence and finite numbers.

#include <gtest/gtest.h>

#include <chrono>

#include "cdpr_kinetostatics/robot/robot_description_yaml.h"
#include "hostile_requests.h"
#include "node_client.h"
#include "ros/cable_service.h"
#include "ros/forward_service.h"
#include "ros/inverse_service.h"

namespace cdpr_kinetostatics {
namespace {

constexpr int kRequests = 300;
constexpr double kTimeout = 0.02;  // [s]
// How much later than the timeout an answer may come [s]: a step of the solver, on a busy machine with sanitizers.
constexpr double kGrace = 1.0;

class AnyRequest : public testing::TestWithParam<const char*> {
 protected:
  AnyRequest() { parameters_.robot = loadRobotFile(std::string(ROBOT_DIR) + "/" + GetParam() + ".yaml").robot; }

  template <typename Response>
  void expectAnswer(const Response& response, std::uint8_t model, std::chrono::steady_clock::time_point start) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), kTimeout + kGrace);
    EXPECT_TRUE(isFinite(response));
    EXPECT_NE(response.report.code, SolveReport::UNSET);
    EXPECT_NE(response.report.code, SolveReport::INTERNAL_ERROR) << response.report.message;
    // A solved request has something to say where the node chose the models, as it does by default, where straight
    // lines contradict each other, and where a freedom is open.
    const bool chosen = model == SolverOptions::AUTO || model == SolverOptions::MODEL_DEFAULT;
    const std::string& message = response.report.message;
    if (response.report.code != SolveReport::CONVERGED || chosen) {
      EXPECT_FALSE(message.empty());
    } else if (model != SolverOptions::STRAIGHT) {
      EXPECT_TRUE(message.empty() || message.find("freedom is open") != std::string::npos) << message;
    }
  }

  NodeParameters parameters_;
  HostileRequests requests_{parameters_.robot, kTimeout, false, 1};
};

TEST_P(AnyRequest, Forward) {
  for (int i = 0; i < kRequests; ++i) {
    const ForwardKinetostatics::Request request = requests_.forward();
    SCOPED_TRACE(testing::Message() << "request " << i << "\n" << request);
    const auto start = std::chrono::steady_clock::now();
    expectAnswer(serveForward(parameters_, request), request.options.model, start);
  }
}

TEST_P(AnyRequest, Inverse) {
  for (int i = 0; i < kRequests; ++i) {
    const InverseKinetostatics::Request request = requests_.inverse();
    SCOPED_TRACE(testing::Message() << "request " << i << "\n" << request);
    const auto start = std::chrono::steady_clock::now();
    expectAnswer(serveInverse(parameters_, request), request.options.model, start);
  }
}

TEST_P(AnyRequest, Cable) {
  for (int i = 0; i < 2 * kRequests; ++i) {
    const SolveCable::Request request = requests_.cable();
    SCOPED_TRACE(testing::Message() << "request " << i << "\n" << request);
    const auto start = std::chrono::steady_clock::now();
    expectAnswer(serveCable(parameters_, request), request.options.model, start);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, AnyRequest, testing::Values("cogiro", "scampi", "paper_point_mass"),
                         [](const auto& robot) { return robot.param; });

}  // namespace
}  // namespace cdpr_kinetostatics
