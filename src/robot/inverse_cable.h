// A cable of inverse kinetostatics: its state, and how length and forces follow from its pull and the platform's turn
// (docs/theory.md section 5, "Inverse kinetostatics").
//
// The pull is the component along the chord of the force in the middle of the cable, equation (36a). Between fixed ends
// a taut cable's pull is nearly its tension. T_A is no coordinate for a slack one: it has a least value, the fold, at
// which the length's derivative with respect to it is infinite. Force, length and T_A are smooth functions of the pull
// on both sides of the fold.
#pragma once

#include <Eigen/Core>

#include "cable/sagging_cable.h"
#include "cdpr_kinetostatics/robot/robot_description.h"
#include "geometry/cable_plane.h"
#include "robot/coupled_newton.h"

namespace cdpr_kinetostatics {

// Slopes of T_A over the pull above which a cable is so taut that second derivatives are left out: for a search from
// afar, whose multipliers weigh them heavily, and along a path.
constexpr double kTautInSearch = 0.9995;
constexpr double kTautOnPath = 0.9;

struct InverseCable {
  SaggingCable cable;
  CablePlane plane;
  double lower = 0.0;  // limits of T_A [N]
  double upper = 0.0;

  // Of the last linearisation: (H, V, L) change by start + by_pull * (change of the pull) + byTurn() * rotation, and by
  // half of bend times the square of the pull's change; start is what closes the cable at its pull.
  double chord = 0.0;     // of the straight rope, from where it leaves its pulley if there is one [m]
  Eigen::Vector2d along;  // unit vector of the chord, towards B
  double open = 0.0;      // distance of the cable's end from B [m]
  double pull = 0.0;      // [N]
  double tension = 0.0;   // T_A of the closed cable [N]
  double slope = 0.0;     // dT_A/d(pull)
  double curvature = 0.0;
  Eigen::Vector3d start, by_pull, bend;
  Eigen::Matrix<double, 3, 2> by_end;  // at constant pull
  // The pulls that the limits allow, to second order [N].
  double least = 0.0, most = 0.0;
  bool at_fold = false;    // the least pull is that of the fold
  bool too_heavy = false;  // no pull keeps T_A below its upper limit

  // At the description's end of the cable at this pose. False: the cable cannot be evaluated, or has no stiffness,
  // here.
  bool linearise(const CableDescription& description, const Pose& pose, Steps steps, double taut);

  // From a linearised cable: steps to this pull and to a pose that this small turn led to, and linearises, until the
  // cable is closed there; a closed form to rounding, a bending cable to where its linearisation serves. The pull is
  // moved into the limits found there. False: it was not to be closed, and has to be linearised anew.
  bool close(const CableDescription& description, const Pose& pose, Steps steps, double new_pull,
             const Eigen::Vector3d& turn);

  // Of (H, V, L) towards this pull [N], and with this small turn [rad].
  Eigen::Vector3d change(double new_pull) const { return start + by_pull * (new_pull - pull); }
  Eigen::Vector3d change(double new_pull, const Eigen::Vector3d& turn) const {
    return change(new_pull) + byTurn() * turn;
  }

  // d(H, V, L)/d(turn) at constant pull.
  Eigen::Matrix3d byTurn() const;

  // How far the pull is from those that the limits allow [N].
  double beyondLimits() const;

  // Size of a change of (H, V, L), relative to tension and length.
  double size(const Eigen::Vector3d& change) const;

  // d(T_A)/d(turn) at constant pull [N].
  Eigen::RowVector3d tensionByTurn() const;

  // On the platform, of the closed cable [N].
  Eigen::Vector3d closedForce() const { return force() + forceByCable() * start; }
  // On the platform, from (H, V, L) as they are [N].
  Eigen::Vector3d force() const;
  // d(that force)/d(H, V, L), equation (31).
  Eigen::Matrix3d forceByCable() const;

 private:
  struct Tangent {
    Eigen::Vector3d by_pull;
    double slope;
  };

  bool measureCurvature(double taut);
  // Of this cable, closed, at a pull that is larger by so much.
  bool tangentBeside(double change_of_pull, Tangent* tangent) const;
  void limitPull();
  // Less than any longer cable's at this place: of an endless catenary, or of a line without tension [N].
  double pullOfEndless() const;
};

}  // namespace cdpr_kinetostatics
