// The quiet middle of a bending cable, between the bending layers of its ends, in closed form
// (docs/theory.md section 3).
//
// Away from its ends the cable follows the one solution without growing and decaying modes: a power series in
// sigma = q^2/T^3, the square of layer thickness over radius of curvature (units of shot.h), which depends on
// the local force (h, q t - v) alone. Perturbations of it grow or decay like exp(t sqrt(T)).
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "cable/shot.h"

namespace cdpr_kinetostatics {

// True if the force (h, q t - v) keeps clear of zero between t0 and t1, and of the direction -x.
bool hasQuietForce(const ShotParameters& parameters, double t0, double t1);

// Terms of the series that reach the error asked for in alpha [rad] between t0 and t1; 0: it cannot.
int slowOrder(const ShotParameters& parameters, double t0, double t1, double error);

struct SlowState {
  double alpha = 0.0;
  double moment = 0.0;
  double tension = 0.0;  // magnitude of the force
  // Tension and direction of the force, differentiated with respect to (h, v, t).
  Eigen::RowVector3d tension_derivative = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d turn_derivative = Eigen::RowVector3d::Zero();
  // (alpha, moment) differentiated with respect to (h, v, t).
  Eigen::Matrix<double, 2, 3> derivative = Eigen::Matrix<double, 2, 3>::Zero();

  // Where the cable departs by (da, dm) from this state, dm = -decay da is the mode that decays with t, and
  // dm = growth da the one that grows.
  double decay = 0.0;
  double growth = 0.0;
  // d(x, y)/d(da): what a mode adds to the displacement as it decays ahead of here, or grew behind here.
  Eigen::Vector2d ahead = Eigen::Vector2d::Zero();
  Eigen::Vector2d behind = Eigen::Vector2d::Zero();

  // Of decay and growth, and of ahead and behind, with respect to (h, v, t), to leading order.
  Eigen::RowVector3d rateDerivative() const { return 0.5 / std::sqrt(tension) * tension_derivative; }
  Eigen::Matrix<double, 2, 3> shiftDerivative(const Eigen::Vector2d& shift) const {
    return Eigen::Vector2d(-shift.y(), shift.x()) * turn_derivative - 0.5 / tension * shift * tension_derivative;
  }
};

SlowState slowState(const ShotParameters& parameters, double t, int order);

struct SlowStretch {
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();                        // (x, y) from t0 to t1
  Eigen::Matrix<double, 2, 4> derivative = Eigen::Matrix<double, 2, 4>::Zero();  // with respect to (h, v, t0, t1)
};

SlowStretch slowStretch(const ShotParameters& parameters, double t0, double t1, int order);

// The integral of q dt/T from t0 to t1, which bounds both the turn of the force and the logarithm of its growth;
// and t where a share of it in [0, 1] is reached.
double riseOfForce(const ShotParameters& parameters, double t0, double t1);
double atShareOfRise(const ShotParameters& parameters, double t0, double t1, double share);

}  // namespace cdpr_kinetostatics
