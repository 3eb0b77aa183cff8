// A cable of inverse kinetostatics: its state, and how length and forces follow from its tension and the platform's
// turn, to first order (docs/theory.md section 5, "Inverse kinetostatics").
#pragma once

#include <Eigen/Core>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "geometry/cable_plane.h"
#include "robot/coupled_newton.h"

namespace cdpr_kinetostatics {

struct InverseCable {
  SaggingCable cable;
  CablePlane plane;
  double lower = 0.0;  // limits of T_A in use [N]
  double upper = 0.0;

  // Of the last linearisation: (H, V, L) change by start + by_tension * (t - T_A) + by_turn * rotation; start is by_end
  // times what is open at B.
  double open = 0.0;  // distance of the cable's end from B [m]
  Eigen::Vector3d start, by_tension;
  Eigen::Matrix<double, 3, 2> by_end;
  Eigen::Matrix3d by_turn;

  // At the description's end of the cable at this pose. False: the cable cannot be evaluated, or has no stiffness,
  // here.
  bool linearise(const CableDescription& description, const Pose& pose, Steps steps);

  // Of (H, V, L) towards this tension [N] and with this small turn [rad].
  Eigen::Vector3d change(double tension, const Eigen::Vector3d& turn) const {
    return start + by_tension * (tension - cable.tensionA()) + by_turn * turn;
  }

  // Size of a change of (H, V, L), relative to tension and length.
  double size(const Eigen::Vector3d& change) const;

  // On the platform, from (H, V, L) as they are [N].
  Eigen::Vector3d force() const;
  // d(that force)/d(H, V, L), equation (31).
  Eigen::Matrix3d forceByCable() const;
};

}  // namespace cdpr_kinetostatics
