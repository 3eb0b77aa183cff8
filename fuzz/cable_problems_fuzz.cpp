// The three problems of one cable, on every model.
#include "cdpr_kinetostatics/cable/cable_solver.h"
#include "fuzzed_input.h"
#include "invariants.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cdpr_kinetostatics;
  FuzzedInput input(data, size);
  CableSolverOptions options;
  options.model = input.model();
  options.tolerance = input.magnitude(1e-10, 1e-4);
  options.accuracy = input.magnitude(1e-7, 1e-1);
  options.timeout = std::chrono::duration<double>(0.05);
  options.profile_points = input.flag() ? 0 : input.count(0, 20);
  const CableProperties cable = input.cable();
  CableSolution solution;
  switch (input.count(1, 3)) {
    case 1: {
      const double length = input.magnitude(1e-2, 1e3);
      const double h = input.number(-1e2, 1e4);
      solution = findPosition(cable, length, h, input.number(-1e4, 1e4), options);
      break;
    }
    case 2: {
      const double x = input.number(0.0, 1e2);
      const double y = input.number(-1e2, 1e2);
      const double chord = std::hypot(x, y);
      const double length = input.flag() ? chord * input.number(0.98, 1.3) : input.magnitude(1e-2, 1e3);
      solution = findForces(cable, length, x, y, options);
      break;
    }
    default: {
      const double x = input.number(0.0, 1e2);
      const double y = input.number(-1e2, 1e2);
      const double tension = input.magnitude(1e-2, 1e6);
      solution = findLength(cable, x, y, tension, input.flag() ? 0.0 : input.number(0.0, 2e2), options);
    }
  }
  requireHonest(solution);
  requireClosed(cable, solution);
  return 0;
}
