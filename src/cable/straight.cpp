#include "cable/straight.h"

#include <algorithm>
#include <cmath>

namespace cdpr_kinetostatics {

EndPoint straightEnd(const CableProperties& cable, double h, double v_a, double length) {
  CableProperties weightless = cable;
  weightless.weight = 0.0;
  EndPoint end = catenaryEnd(weightless, h, v_a - 0.5 * cable.weight * length, length);
  end.jacobian.col(2) -= 0.5 * cable.weight * end.jacobian.col(1);
  return end;
}

ForcesAtA straightForces(const CableProperties& cable, double length, double x, double y) {
  const double chord = std::hypot(x, y);
  const double half_weight = 0.5 * cable.weight * length;
  if (chord <= length) return {0.0, half_weight};
  const double tension = cable.axial_stiffness * (chord - length) / length;
  return {tension * x / chord, half_weight - tension * y / chord};
}

}  // namespace cdpr_kinetostatics
