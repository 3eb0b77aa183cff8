#include "cable/pulley_layer.h"

#include <cmath>

#include "cable/rope_on_pulley.h"

namespace cdpr_kinetostatics {
namespace {

// How the stretch of the layer moves the end, as a share of strain^2 and of how much shorter the bent layer reaches:
// 0.2 to 0.35 with strains of 7 and 18 %, by comparison with the bending model.
constexpr double kByStrain = 0.35;

// A quantity with its derivatives by the tension and by the direction of the force at A.
struct Polar {
  double value, by_tension, by_angle;
};

// The force at A: its size and the direction in which it pulls.
struct Pull {
  double tension, c, s;
};

// Of half the angle by which the layer turns the rope.
Polar sineOfHalfTurn(const CableProperties& cable, const Pull& pull, const Polar& lambda, const Polar& curvature) {
  const auto [tension, c, s] = pull;
  const double q = cable.weight;
  const double sense = senseOf(cable.pulley);
  const double jump = 1.0 / cable.pulley.radius + sense * curvature.value;
  // The layer grows thinner with the tension: it turns the less, the more this rises along it.
  const double rise = 0.25 * lambda.value * q / tension;
  const Polar fall{1.0 / (1.0 + rise * s), 1.5 * rise * s / (tension * std::pow(1.0 + rise * s, 2)),
                   -rise * c / std::pow(1.0 + rise * s, 2)};
  const double half = 0.5 * lambda.value * jump;
  return {half * fall.value,
          0.5 * (lambda.by_tension * jump + lambda.value * sense * curvature.by_tension) * fall.value +
              half * fall.by_tension,
          0.5 * lambda.value * sense * curvature.by_angle * fall.value + half * fall.by_angle};
}

}  // namespace

PulleyLayer pulleyLayer(const CableProperties& cable, const ForcesAtA& forces) {
  PulleyLayer layer;
  if (!hasPulley(cable) || cable.bending_stiffness == 0.0) return layer;
  const double q = cable.weight;
  const double sense = senseOf(cable.pulley);
  const double tension = forces.tension();
  const double c = forces.horizontal / tension;
  const double s = -forces.vertical / tension;
  const double e = 1.0 + tension / cable.axial_stiffness;

  const double thickness = std::sqrt(cable.bending_stiffness / tension);
  const Polar lambda{thickness, -0.5 * thickness / tension, 0.0};
  const double bend = q * c / (e * tension);
  const Polar curvature{bend, -bend * (1.0 / tension + 1.0 / (cable.axial_stiffness * e)), -q * s / (e * tension)};
  const Polar sine = sineOfHalfTurn(cable, {tension, c, s}, lambda, curvature);
  const double cosine = std::sqrt(1.0 - sine.value * sine.value);  // of half the turn

  const double by_sine = 2.0 * sense / cosine;
  const Polar turn{2.0 * sense * std::asin(sine.value), by_sine * sine.by_tension, by_sine * sine.by_angle};

  // Across the force by the balance of moments, of which the weight of what lies beside the asymptote has a part.
  const double area = q * thickness * thickness;
  const double offset = (-momentAtDeparture(cable) - area * turn.value * s) / tension;
  const Polar across{offset, (-offset + area * s * (turn.value / tension - turn.by_tension)) / tension,
                     -area / tension * (turn.by_angle * s + turn.value * c)};
  const Polar mean{lambda.value * curvature.value,
                   lambda.by_tension * curvature.value + lambda.value * curvature.by_tension,
                   1.0 + lambda.value * curvature.by_angle};  // turn of the catenary to one thickness

  // Along it because the layer is not straight, and under less tension for that.
  const double stretched = 2.0 - 1.0 / e;
  const double short_by = 2.0 * thickness * (1.0 - cosine);
  const double lost = 2.0 * stretched * thickness * sine.value / cosine;
  const Polar along{-stretched * short_by,
                    -short_by / (cable.axial_stiffness * e * e) - stretched * short_by * lambda.by_tension / thickness -
                        lost * sine.by_tension,
                    -lost * sine.by_angle};

  const double angle = std::atan2(s, c) + mean.value;
  const Eigen::Vector2d normal(-std::sin(angle), std::cos(angle));
  const Eigen::Vector2d inwards(-std::cos(angle), -std::sin(angle));
  const Eigen::Vector2d tangent(c, s);
  layer.thickness = thickness;
  layer.turn = turn.value;
  // The first terms left out: (47), and how the stretch of the layer changes its shape, of second order in the strain.
  layer.beyond = 0.125 * area * turn.value * turn.value / tension * Eigen::Vector2d(2.0 * s * c, s * s - c * c) +
                 kByStrain * std::pow(tension / cable.axial_stiffness, 2) * short_by * tangent;
  layer.shift = across.value * normal + along.value * tangent;
  Eigen::Matrix2d polar;  // by tension and angle
  polar.col(0) = across.by_tension * normal + across.value * mean.by_tension * inwards + along.by_tension * tangent;
  polar.col(1) = across.by_angle * normal + across.value * mean.by_angle * inwards + along.by_angle * tangent +
                 along.value * Eigen::Vector2d(-s, c);
  Eigen::Matrix2d by_forces;  // of tension and angle
  by_forces << c, -s, -s / tension, -c / tension;
  layer.turn_by = Eigen::RowVector2d(turn.by_tension, turn.by_angle) * by_forces;
  layer.shift_by = polar * by_forces;
  return layer;
}

}  // namespace cdpr_kinetostatics
