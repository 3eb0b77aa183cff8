// What the kinds of cables whose end is a closed form of (H, V, L) have in common: they hold nothing but (H, V, L), and
// have no nodes that move along. Each kind adds where its end is (linearise) and its problems.
#pragma once

#include <Eigen/Core>

#include "cable/forces_at_a.h"
#include "cable/length_search.h"
#include "cable/shot.h"
#include "cable/solve_outcome.h"
#include "cable/tautness.h"
#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/end_point.h"

namespace cdpr_kinetostatics {

class ClosedFormCable {
 public:
  // Problem 3 follows T_A(L) from the length of a straight line: following is cheap.
  static constexpr bool kStartsFromCatenary = false;

  ClosedFormCable() = default;
  explicit ClosedFormCable(const CableProperties& cable) : properties_(cable) {}

  const CableProperties& properties() const { return properties_; }
  const ForcesAtA& forces() const { return forces_; }
  double length() const { return length_; }
  const EndPoint& end() const { return end_; }
  // The length of the part that hangs freely, and its derivative by (H, V, L): all of it.
  double freeLength() const { return length_; }
  Eigen::RowVector3d freeLengthDerivative() const { return Eigen::RowVector3d::UnitZ(); }

  void start(double length, const ForcesAtA& forces);

  double dampingFor(const Eigen::Vector3d& change) const;
  double angleChange(const Eigen::Vector3d& /*change*/) const { return 0.0; }
  void step(const Eigen::Vector3d& change, double damping);
  void follow(const Eigen::Vector3d& change) { step(change, 1.0); }
  bool stepsFit() const { return true; }
  bool onBranch() const { return !pushes(forces_); }

  // Those of a cable that sags; a straight line has others.
  bool lengthIsChord(double x, double y, double tension_a, double length_hint) const {
    return isString(properties_, x, y, tension_a, length_hint);
  }
  double longestLength(double chord, double tension_a) const {
    return longestSagging(properties_.weight, chord, tension_a);
  }
  IntegrationWork work() const { return {}; }

 protected:
  // The end under (H, V, L); false where it or its derivatives do not exist.
  bool setEnd(const EndPoint& end);

 private:
  CableProperties properties_;
  ForcesAtA forces_;
  double length_ = 0.0;
  EndPoint end_;
};

// The closed form is the answer.
inline SolveOutcome evaluated() { return {{Code::kConverged, ""}}; }

}  // namespace cdpr_kinetostatics
