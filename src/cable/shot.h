// One shot of the bending cable: Dormand-Prince RK45 with step control over a stretch of cable, with the
// variational equations beside the state, (16) and (17) of docs/theory.md.
//
// Dimensionless: a reference force F0 measures forces, l0 = sqrt(EI/F0), the bending layer's thickness at
// that force, measures lengths and F0*l0 = sqrt(EI*F0) moments. With t = s/l0 the cable obeys
//
//     alpha' = e m    m' = e S    x' = e cos(alpha)    y' = e sin(alpha)
//     T = h cos(alpha) - v(t) sin(alpha)    S = h sin(alpha) + v(t) cos(alpha)    e = 1 + eps T
//
// where v(t) = v - q t. x and y do not feed back: they are quadratures. docs/theory.md writes w for y.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cdpr_kinetostatics {

// Dimensionless parameters of the equations above.
struct ShotParameters {
  double h = 0.0;    // H/F0
  double v = 0.0;    // V/F0
  double q = 0.0;    // q l0/F0
  double eps = 0.0;  // F0/EA; 0 is the inextensible cable
};

struct ShotState {
  double alpha = 0.0;
  double moment = 0.0;
  double x = 0.0;
  double y = 0.0;
};

// d(alpha, moment, x, y)/dt at t.
ShotState shotDerivative(const ShotParameters& parameters, double t, const ShotState& state);

// What an integration took: steps tried, those refused by the step control included, and right-hand sides of (16), each
// evaluated with its variational equations (17).
struct IntegrationWork {
  int steps = 0;
  int evaluations = 0;

  IntegrationWork& operator+=(const IntegrationWork& other) {
    steps += other.steps;
    evaluations += other.evaluations;
    return *this;
  }
};

struct Shot {
  ShotState end;
  // d(alpha, moment, x, y)(t1)/d(alpha0, moment0, h, v)
  Eigen::Matrix4d sensitivity = Eigen::Matrix4d::Identity();
  // d(alpha)/d(alpha0, moment0) after each step: where its sign changes, buckling begins.
  std::vector<Eigen::Vector2d> turning;
  // Largest error of alpha or of the moment that a step taken makes, by the estimate of the pair of orders 5 and 4.
  double step_error = 0.0;
  IntegrationWork work;
};

// The accepted steps of a shot, to be taken again: a residual evaluated on a frozen grid is a smooth
// function of its unknowns, which Newton's method needs to converge to rounding.
using StepGrid = std::vector<double>;

// Integrates from (t0, start) to t1 in steps that each change alpha [rad] and the moment by at most tolerance too much
// or too little. Fills grid with the steps taken. Returns false when the step cap is reached or the state leaves every
// physical range: the shot is to be rejected.
bool shootAdaptive(const ShotParameters& parameters, double t0, double t1, const ShotState& start, double tolerance,
                   StepGrid* grid, Shot* shot);

// The same on the steps of an earlier call, each times scale.
bool shootOnGrid(const ShotParameters& parameters, double t0, const ShotState& start, const StepGrid& grid,
                 double scale, Shot* shot);

}  // namespace cdpr_kinetostatics
