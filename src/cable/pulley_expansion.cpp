#include "cable/pulley_expansion.h"

#include <cmath>

#include "cable/pulley_end.h"
#include "cable/pulley_layer.h"
#include "cable/rope_on_pulley.h"

namespace cdpr_kinetostatics {
namespace {

// The free part must be so many thicknesses of the pulley's layer long: it is thicker than that of a hinged end, and
// what is left of it at B must not count.
constexpr double kLeastLayers = 8.0;

}  // namespace

BendingExpansion pulleyExpansion(const CableProperties& cable, const ForcesAtA& forces, double length) {
  const PulleyEnd catenary = pulleyEnd(cable, FreeShape::kCatenary, forces, length);
  if (cable.bending_stiffness == 0.0) {
    BendingExpansion none;
    none.trusted = true;
    return none;
  }
  const PulleyEnd corrected = pulleyEnd(cable, FreeShape::kCorrected, forces, length);
  BendingExpansion effect =
      bendingExpansion(freePartOf(cable), forces.horizontal, forces.vertical, corrected.free_length);
  const PulleyLayer layer = pulleyLayer(cable, forces);
  const double reach = corrected.free_length / layer.thickness;  // infinite without a layer
  effect.beyond_first += layer.beyond;
  effect.beyond_first += 2.0 * std::exp(-reach) * layer.shift;
  effect.end = corrected.end.position - catenary.end.position + effect.beyond_first;
  effect.trusted = effect.trusted && reach > kLeastLayers && effect.end.allFinite() &&
                   checkContact(cable, forces, corrected.angle).ok();
  return effect;
}

}  // namespace cdpr_kinetostatics
