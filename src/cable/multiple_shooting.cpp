#include "cable/multiple_shooting.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "cable/catenary.h"
#include "cable/mesh_rules.h"
#include "cable/shape_measures.h"

namespace cdpr_kinetostatics {
namespace {

// Steps may be kept while they make up to so many times the error that was asked of them: it is a tenth of what the
// tolerance allows (shooting_accuracy.cpp).
constexpr double kLargestStepError = 4.0;

// A determinant of less than this share of its terms is zero: rounding of doubles leaves 1e-16.
constexpr double kRounding = 1e-15;

// Beyond this angle a turn of the force says nothing of the nodes: follow() then moves them in proportion to the
// force's components. [rad]
constexpr double kLargestTurn = 0.5;

}  // namespace

void MultipleShooting::begin(const CableProperties& cable, double length, const Eigen::Vector2d& force,
                             const ShootingAccuracy& accuracy, Middle middle) {
  accuracy_ = accuracy;
  shape_.cable.properties = cable;
  shape_.cable.length = length;
  shape_.cable.force = force;
  length_ = length;
  on_pulley_.release();
  if (!beginsAtEyelet()) {
    const ForcesAtA forces{force.x(), force.y()};
    shape_.cable.length -= heldRope(cable, forces, tautDeparture(cable, forces)).length;
  }
  shape_.cable.chooseUnits();
  shape_.grid_length = shape_.cable.length;
  placeSegments(middle);
}

void MultipleShooting::placeSegments(Middle middle) {
  shape_.mesh.place(shape_.cable, accuracy_, middle);
  shape_.layOutSegments();
}

void MultipleShooting::start(const CableProperties& cable, double length, double horizontal_force,
                             double vertical_force_a, double tolerance, Middle middle) {
  const double turned = std::abs(catenaryAngle(cable, horizontal_force, vertical_force_a, length) -
                                 catenaryAngle(cable, horizontal_force, vertical_force_a, 0.0));
  const double force = std::hypot(horizontal_force, vertical_force_a);
  begin(cable, length, {horizontal_force, vertical_force_a},
        ShootingAccuracy(tolerance, angleScale(cable, length, force, turned)), middle);
  shape_.startOnCatenary();
}

void MultipleShooting::startStraight(const CableProperties& cable, double length, double x, double y,
                                     double tolerance) {
  const double chord = std::hypot(x, y);
  const double tension = cable.axial_stiffness * (chord / length - 1.0);
  startAlong(cable, length, {tension * x / chord, 0.5 * cable.weight * length - tension * y / chord}, std::atan2(y, x),
             tolerance);
}

void MultipleShooting::startAlong(const CableProperties& cable, double length, const ForcesAtA& forces, double angle,
                                  double tolerance) {
  const double along = std::hypot(forces.horizontal, forces.vertical - 0.5 * cable.weight * length);
  begin(cable, length, {forces.horizontal, forces.vertical},
        ShootingAccuracy(tolerance, angleScale(cable, length, along, 1.0)), Middle::kShot);
  for (ShootingSegment& segment : shape_.segments) segment.node << angle, 0.0;
  shape_.last_node << angle, 0.0;
}

std::optional<double> MultipleShooting::startFromAngle(const CableProperties& cable, double length,
                                                       double horizontal_force, double vertical_force_a, double angle,
                                                       double tolerance, SolveLimits::Clock::time_point deadline) {
  begin(cable, length, {horizontal_force, vertical_force_a}, ShootingAccuracy(tolerance), Middle::kShot);
  const double span = shape_.cable.span();
  ShotState state{angle, 0.0, 0.0, 0.0};
  for (ShootingSegment& segment : shape_.segments) {
    segment.node << state.alpha, state.moment;
    if (SolveLimits::isPast(deadline)) return std::nullopt;
    const bool shot = shootAdaptive(shape_.cable.parameters(), segment.begin * span, segment.end * span, state,
                                    accuracy_.ofStep(), &segment.grid, &segment.shot);
    work_ += segment.shot.work;
    if (!shot) return std::nullopt;
    state = {segment.shot.end.alpha, segment.shot.end.moment, 0.0, 0.0};
  }
  shape_.last_node << state.alpha, 0.0;
  return state.moment;
}

void MultipleShooting::changeProperties(const CableProperties& cable) {
  if (hasQuietMiddle() && !shape_.mesh.hasShotBend()) replaceMesh(Middle::kShot);
  const double before = shape_.cable.unit_length;
  shape_.cable.properties = cable;
  shape_.cable.chooseUnits();
  // The moment in its unit is the curvature times the unit of length.
  for (ShootingSegment& segment : shape_.segments) {
    segment.node.y() *= shape_.cable.unit_length / before;
    segment.grid.clear();
  }
  accuracy_ = ShootingAccuracy(accuracy_.tolerance());
  shape_.evaluateAllQuietEnds();
}

// From the catenary again: a shot from nodes that are not joined would not lead where the cable is, and a cable
// whose middle was quiet is near its catenary. A loop that bends more sharply than its own layers is not: it keeps its
// shape.
void MultipleShooting::replaceMesh(Middle middle) {
  const ShotParameters p = shape_.cable.parameters();
  if (p.h >= std::cbrt(p.q * p.q)) {
    placeSegments(middle);
    shape_.startOnCatenary();
    return;
  }
  const SegmentedCable before = shape_;
  placeSegments(middle);
  for (ShootingSegment& segment : shape_.segments) segment.node = before.stateAt(segment.begin);
  shape_.evaluateAllQuietEnds();
}

bool MultipleShooting::tooManySegments() const { return segments() > kMaxSegments; }

bool MultipleShooting::linearise(bool adapt, SolveLimits::Clock::time_point deadline) {
  if (adapt && !meshFits()) replaceMesh(Middle::kQuiet);
  if (tooManySegments() || !(shape_.cable.length > 0.0)) return false;
  if (!integrate(adapt, deadline)) return false;
  if (adapt) shape_.grid_length = shape_.cable.length;
  const EndMoments moments{shape_.cable.momentAtA(), 0.0, hasPulley(properties())};
  if (!chain_.eliminate(shape_.segments, shape_.last_node, moments)) return false;
  if (!beginsAtEyelet()) {
    const bool linked = on_pulley_.link(shape_, chain_, length_);
    end_ = on_pulley_.end();
    return linked;
  }
  const ShootingChain::Affine& end = chain_.end();
  end_.position = shape_.cable.unit_length * end.col(0);
  end_.jacobian.leftCols<2>() = shape_.cable.unit_length / shape_.cable.unit_force * end.middleCols<2>(1);
  end_.jacobian.col(2) = end.col(3);
  return true;
}

bool MultipleShooting::integrate(bool adapt, SolveLimits::Clock::time_point deadline) {
  const ShotParameters p = shape_.cable.parameters();
  const double span = shape_.cable.span();
  const double tolerance = accuracy_.ofStep();
  step_error_ = 0.0;
  for (ShootingSegment& segment : shape_.segments) {
    if (segment.quiet) continue;
    if (SolveLimits::isPast(deadline)) return false;
    const double t0 = segment.begin * span;
    const double t1 = segment.end * span;
    const ShotState start = SegmentedCable::beginOf(segment);
    const bool shot = adapt ? shootAdaptive(p, t0, t1, start, tolerance, &segment.grid, &segment.shot)
                            : shootOnGrid(p, t0, start, segment.grid, shape_.gridScale(), &segment.shot);
    work_ += segment.shot.work;
    if (!shot) return false;
    step_error_ = std::max(step_error_, segment.shot.step_error / tolerance);
    segment.begin_derivative = shotDerivative(p, t0, start);
    segment.end_derivative = shotDerivative(p, t1, segment.shot.end);
  }
  for (std::size_t k = 0; k < shape_.segments.size(); ++k) {
    if (shape_.segments[k].quiet) shape_.evaluateQuietSegment(k);
  }
  return true;
}

bool MultipleShooting::stepsFit() { return step_error_ <= kLargestStepError && meshFits(); }

Eigen::Vector4d MultipleShooting::factors(const Eigen::Vector2d& forces, double free_length) const {
  const ShotCable& cable = shape_.cable;
  return {1.0, forces.x() / cable.unit_force, forces.y() / cable.unit_force, free_length / cable.unit_length};
}

Eigen::Vector4d MultipleShooting::factors(const Eigen::Vector3d& change) const {
  return factors(change.head<2>(), on_pulley_.newtonChange(change));
}

void MultipleShooting::step(const Eigen::Vector3d& change, double damping) {
  move(damping * factors(change), damping * change.head<2>(), damping * on_pulley_.newtonChange(change));
  length_ += damping * change.z();
}

// Nodes turn with the force along the chord, (H, V - q L/2), as a light cable does: its angle and its size are what
// they follow, not its components, whose second order would stretch a stiff cable.
void MultipleShooting::follow(const Eigen::Vector3d& change) {
  const double weight = shape_.cable.properties.weight;
  const double free_length = on_pulley_.followedChange(change);
  const Eigen::Vector2d& force = shape_.cable.force;
  const Eigen::Vector2d weight_change(0.0, 0.5 * weight * free_length);
  const Eigen::Vector2d old_force(force.x(), force.y() - 0.5 * weight * shape_.cable.length);
  const Eigen::Vector2d new_force = old_force + change.head<2>() - weight_change;
  const Eigen::Vector2d across(-old_force.y(), old_force.x());
  const double turn = std::atan2(across.dot(new_force), old_force.dot(new_force));
  Eigen::Vector2d followed = change.head<2>();
  if (std::abs(turn) < kLargestTurn && old_force.norm() > 0.0) {
    followed = weight_change + (new_force.norm() / old_force.norm() - 1.0) * old_force + turn * across;
  }
  work_ = {};
  Eigen::Vector4d by = factors(followed, free_length);
  by[0] = 0.0;
  move(by, change.head<2>(), free_length);
  length_ += change.z();
}

void MultipleShooting::move(const Eigen::Vector4d& factors, const Eigen::Vector2d& forces, double free_length) {
  for (std::size_t k = 0; k < shape_.segments.size(); ++k) {
    shape_.segments[k].node += chain_.change(k) * factors;
  }
  shape_.last_node += chain_.change(shape_.segments.size()) * factors;
  shape_.cable.force += forces;
  shape_.cable.length += free_length;
  // What is left of the end's modes in the middle is a small difference: both sides of it must have moved.
  shape_.evaluateAllQuietEnds();
}

// d(x, y)/d(H, V_B): V = V_B + q times the free length, which depends on the forces.
Eigen::Matrix2d MultipleShooting::complianceAtB() const {
  const double weight = shape_.cable.properties.weight;
  const Eigen::RowVector2d free_length_by = freeLengthDerivative().head<2>();
  Eigen::Matrix2d at_b_by_at_a;
  at_b_by_at_a << 1.0, 0.0, -weight * free_length_by.x(), 1.0 - weight * free_length_by.y();
  return end_.jacobian.leftCols<2>() * at_b_by_at_a.inverse();
}

bool MultipleShooting::stable() const {
  const Eigen::Matrix2d compliance = beginsAtEyelet() ? Eigen::Matrix2d(end_.jacobian.leftCols<2>()) : complianceAtB();
  // Compliance of the end point against the force (H, q L - V) that acts on it.
  const double xx = compliance(0, 0);
  const double yy = -compliance(1, 1);
  const double xy = 0.5 * (compliance(1, 0) - compliance(0, 1));
  const double determinant = xx * yy - xy * xy;
  const bool opposite = determinant < -kRounding * (xx * xx + yy * yy);
  const int negative = opposite ? 1 : xx + yy < 0.0 ? 2 : 0;
  return chain_.negativeDirections() == negative;
}

Status MultipleShooting::contact() const {
  const ForcesAtA forces{shape_.cable.force.x(), shape_.cable.force.y()};
  return checkContact(properties(), forces, shape_.segments.front().node.x());
}

// The force at A runs past the point where the cable leaves the pulley at this distance, and as far the cable keeps
// from the chord on the side of the pulley's axis; its layer keeps another such distance for its own thickness.
double MultipleShooting::areaOfPulleyMoment() const {
  if (!hasPulley(properties())) return 0.0;
  const double tension = shape_.cable.force.norm();
  const double distance = std::abs(momentAtDeparture(properties())) / tension;
  const double thickness = std::sqrt(properties().bending_stiffness / tension);
  return distance * (0.5 * end_.position.norm() + 2.0 * thickness);
}

double MultipleShooting::areaBelowChord() const { return cdpr_kinetostatics::areaBelowChord(shape_); }

void MultipleShooting::measure(int profile_points, CableSolution* solution) const {
  IntegrationWork work = work_;
  work += measureShape(shape_, profile_points, solution);
  solution->integrator_steps = work.steps;
  solution->evaluations = work.evaluations;
}

int MultipleShooting::steps() const {
  std::size_t sum = 0;
  for (const ShootingSegment& segment : shape_.segments) sum += segment.grid.size();
  return static_cast<int>(sum);
}

void MultipleShooting::restore(const MultipleShooting& earlier) {
  const IntegrationWork work = work_;
  *this = earlier;
  work_ = work;
}

}  // namespace cdpr_kinetostatics
