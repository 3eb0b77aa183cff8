// Every refusal has the right code, a sentence that names the thing, and no NaN.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "finite_solution.h"
#include "known_cables.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A good request to each problem, for a test to spoil.
struct Request {
  CableProperties cable = steelRope();
  double length = 8.5;
  double x = 7.0, y = -4.0;
  double h = 4.0, v = 3.0;
  double tension = 10.0;
  double hint = 0.0;
  CableSolverOptions options;

  CableSolution solve(int problem) const {
    switch (problem) {
      case 1:
        return findPosition(cable, length, h, v, options);
      case 2:
        return findForces(cable, length, x, y, options);
      default:
        return findLength(cable, x, y, tension, hint, options);
    }
  }
};

void expectRefusal(const Request& request, int problem, Code code, const std::string& named) {
  const CableSolution s = request.solve(problem);
  EXPECT_EQ(s.status.code, code) << "problem " << problem << ", " << named << ": " << s.status.message;
  EXPECT_NE(s.status.message.find(named), std::string::npos)
      << "problem " << problem << ": '" << s.status.message << "' does not name '" << named << "'";
  EXPECT_TRUE(isFinite(s)) << "problem " << problem << ", " << named;
  EXPECT_TRUE(s.profile.empty()) << "problem " << problem << ", " << named;
}

constexpr Model kModels[] = {Model::kStraight, Model::kStraightElastic,   Model::kCatenaryInextensible,
                             Model::kCatenary, Model::kCatenaryCorrected, Model::kBendingInextensible,
                             Model::kBending};

TEST(InvalidInput, TheUnspoiledRequestIsServed) {
  for (const int problem : {1, 2, 3}) EXPECT_TRUE(Request().solve(problem).status.ok()) << problem;
}

TEST(InvalidInput, PropertiesOfTheCable) {
  for (const int problem : {1, 2, 3}) {
    for (const Model model : kModels) {
      Request request;
      request.options.model = model;
      for (const double bad : {kNaN, -1.0, kInfinity}) {
        Request spoiled = request;
        spoiled.cable.weight = bad;
        expectRefusal(spoiled, problem, Code::kInvalidInput, "weight is");
        spoiled = request;
        spoiled.cable.bending_stiffness = bad;
        expectRefusal(spoiled, problem, Code::kInvalidInput, "bending_stiffness is");
      }
      for (const double bad : {kNaN, -1.0, 0.0}) {
        Request spoiled = request;
        spoiled.cable.axial_stiffness = bad;
        if (!isInextensible(model)) expectRefusal(spoiled, problem, Code::kInvalidInput, "axial_stiffness is");
      }
    }
  }
}

// Beyond what a cable can be: sums of such numbers leave the range of a double.
TEST(InvalidInput, ValuesThatNoCableHas) {
  for (const int problem : {1, 2, 3}) {
    for (const double bad : {1e-160, 1e-4, 1e19, 1e300}) {
      Request spoiled;
      spoiled.cable.axial_stiffness = bad;
      expectRefusal(spoiled, problem, Code::kInvalidInput, "0.0002 N to 1e+18 N");
    }
    for (const double bad : {1e-300, 1e-25, 1e21, 1e300}) {
      Request spoiled;
      spoiled.cable.bending_stiffness = bad;
      expectRefusal(spoiled, problem, Code::kInvalidInput, "bending_stiffness is");
    }
    for (const double bad : {1e-300, 1e-19, 1e13}) {
      Request spoiled;
      spoiled.cable.weight = bad;
      expectRefusal(spoiled, problem, Code::kInvalidInput, "weight is");
    }
  }
  for (const int problem : {1, 2}) {
    for (const double bad : {1e-120, 1e-30, 1e-7}) {
      Request spoiled;
      spoiled.length = bad;
      expectRefusal(spoiled, problem, Code::kInvalidInput, "length is");
    }
  }
}

TEST(InvalidInput, LengthsAndForces) {
  for (const Model model : kModels) {
    Request request;
    request.options.model = model;
    for (const double bad : {kNaN, kInfinity, 0.0, -1.0, 1e300}) {
      Request spoiled = request;
      spoiled.length = bad;
      expectRefusal(spoiled, 1, Code::kInvalidInput, "length is");
      expectRefusal(spoiled, 2, Code::kInvalidInput, "length is");
    }
    for (const double bad : {kNaN, kInfinity, -kInfinity, 1e300}) {
      Request spoiled = request;
      spoiled.h = bad;
      expectRefusal(spoiled, 1, Code::kInvalidInput, "horizontal_force is");
      spoiled = request;
      spoiled.v = bad;
      expectRefusal(spoiled, 1, Code::kInvalidInput, "vertical_force_a is");
    }
    for (const double bad : {kNaN, kInfinity, 0.0, -5.0}) {
      Request spoiled = request;
      spoiled.tension = bad;
      expectRefusal(spoiled, 3, Code::kInvalidInput, "tension_a is");
    }
  }
}

TEST(InvalidInput, HintsOutOfRange) {
  for (const double bad : {kInfinity, 1e300}) {
    Request spoiled;
    spoiled.hint = bad;
    expectRefusal(spoiled, 3, Code::kInvalidInput, "length_hint is");
  }
}

TEST(InvalidInput, EndPoints) {
  for (const Model model : kModels) {
    for (const int problem : {2, 3}) {
      Request request;
      request.options.model = model;
      for (const double bad : {kNaN, kInfinity, -0.1}) {
        Request spoiled = request;
        spoiled.x = bad;
        expectRefusal(spoiled, problem, Code::kInvalidInput, "x is ");
      }
      for (const double bad : {kNaN, -kInfinity}) {
        Request spoiled = request;
        spoiled.y = bad;
        expectRefusal(spoiled, problem, Code::kInvalidInput, "y is ");
      }
    }
    Request coincident;
    coincident.options.model = model;
    coincident.x = coincident.y = 0.0;
    expectRefusal(coincident, 3, Code::kInvalidInput, "ends");
  }
}

TEST(InvalidInput, Options) {
  for (const int problem : {1, 2, 3}) {
    for (const double bad : {kNaN, 0.0, -1e-8, 1e-16, 0.5, kInfinity}) {
      Request spoiled;
      spoiled.options.tolerance = bad;
      expectRefusal(spoiled, problem, Code::kInvalidInput, "tolerance is");
    }
    for (const int bad : {-1, 1, 2000000000}) {
      Request spoiled;
      spoiled.options.profile_points = bad;
      expectRefusal(spoiled, problem, Code::kInvalidInput, "profile_points is");
    }
    for (const Model bad : {Model::kDefault, static_cast<Model>(9)}) {
      Request spoiled;
      spoiled.options.model = bad;
      expectRefusal(spoiled, problem, Code::kInvalidInput, "model is");
    }
  }
}

TEST(InvalidInput, ADeadlineInThePastIsTimedOut) {
  for (const int problem : {1, 2, 3}) {
    Request request;
    request.options.timeout = std::chrono::seconds(-1);
    expectRefusal(request, problem, Code::kTimedOut, "time");
  }
}

TEST(Infeasible, InextensibleCablesThatAreTooShort) {
  for (const Model model : {Model::kCatenaryInextensible, Model::kBendingInextensible}) {
    Request request;
    request.options.model = model;
    const double chord = std::hypot(7.0, 4.0);
    for (const double length : {1.0, chord * (1.0 - 1e-12), chord}) {
      request.length = length;
      expectRefusal(request, 2, Code::kInfeasible, "length");
    }
  }
}

TEST(Infeasible, AStraightCableOfAnotherLengthThanItsChord) {
  Request request;
  request.options.model = Model::kStraight;
  expectRefusal(request, 2, Code::kInfeasible, "length");
  request.length = std::hypot(7.0, 4.0);  // and of the same length its tension does not follow
  expectRefusal(request, 2, Code::kInvalidInput, "tension");
}

TEST(Infeasible, SlackCablesWithoutWeightOrBendingStiffness) {
  Request request;
  request.cable.weight = 0.0;
  request.options.model = Model::kCatenary;
  expectRefusal(request, 2, Code::kInfeasible, "weight");
  request.options.model = Model::kBending;
  request.cable.bending_stiffness = 0.0;
  expectRefusal(request, 2, Code::kInfeasible, "weight");
}

TEST(Infeasible, CompressionWithoutBendingStiffness) {
  for (const Model model :
       {Model::kStraight, Model::kStraightElastic, Model::kCatenaryInextensible, Model::kCatenary}) {
    Request request;
    request.options.model = model;
    request.h = -1.0;
    expectRefusal(request, 1, Code::kInfeasible, "horizontal_force");
  }
}

TEST(Infeasible, TensionsBelowTheLeastThatHoldsTheCable) {
  for (const Model model : {Model::kStraight, Model::kCatenaryInextensible, Model::kCatenary,
                            Model::kBendingInextensible, Model::kBending}) {
    Request request;
    request.options.model = model;
    request.tension = 0.5;
    expectRefusal(request, 3, Code::kInfeasible, "least tension");
  }
}

TEST(Served, AWeightlessCableThatBends) {
  Request request;
  request.cable.weight = 0.0;
  const CableSolution s = request.solve(2);  // longer than its chord: a bowed strut
  ASSERT_TRUE(s.status.ok()) << s.status.message;
  EXPECT_TRUE(isFinite(s));
  EXPECT_LT(s.horizontal_force, 0.0);
}

}  // namespace
}  // namespace cdpr_kinetostatics
