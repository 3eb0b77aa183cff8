#include "random_cables.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>

#include "cable/catenary.h"

namespace cdpr_kinetostatics {
namespace {

// No rod is thicker than this: radius of gyration over length.
constexpr double kThickest = 0.02;

// Not a library distribution: those differ between implementations.
double uniform(std::mt19937* generator, double low, double high) {
  return low + (high - low) * (static_cast<double>((*generator)()) / 4294967296.0);
}

}  // namespace

double CableCase::chord() const { return std::hypot(x, y); }

std::ostream& operator<<(std::ostream& out, const CableCase& c) {
  return out << std::setprecision(17) << "EA " << c.cable.axial_stiffness << ", EI " << c.cable.bending_stiffness
             << ", q " << c.cable.weight << ", L " << c.length << ", x " << c.x << ", y " << c.y << " (L/chord "
             << std::setprecision(6) << c.length / c.chord() << ", kappa L " << c.layers << ")";
}

double RandomCables::logUniform(double low, double high) {
  return std::exp(uniform(&generator_, std::log(low), std::log(high)));
}

CableCase RandomCables::next() {
  for (;;) {
    CableCase c;
    const double chord = logUniform(shortest_chord, longest_chord);
    const double inclination = uniform(&generator_, -steepest, steepest);
    c.x = chord * std::cos(inclination);
    c.y = chord * std::sin(inclination);
    c.cable.weight = logUniform(0.05, 50.0);
    const double strain = logUniform(least_strain, largest_strain);
    const double load = logUniform(0.5, 1e4);  // tension over weight, of a taut cable
    const double excess = logUniform(1e-4, most_slack - 1.0);
    c.layers = logUniform(fewest_layers, most_layers);
    if (count_ % 2 == 0) {
      const double tension = load * c.cable.weight * chord;
      c.cable.axial_stiffness = tension / strain;
      c.length = chord * (1.0 + std::pow(c.x / chord / load, 2) / 24.0) / (1.0 + strain);
    } else {
      c.cable.axial_stiffness = c.cable.weight * chord / strain;
      c.length = chord * (1.0 + excess);
    }
    const std::optional<ForcesAtA> forces = catenaryForces(c.cable, c.length, c.x, c.y);
    if (!forces) continue;
    const double tension = std::hypot(forces->horizontal, forces->vertical);
    c.cable.bending_stiffness = tension * std::pow(c.length / c.layers, 2);
    if (c.cable.bending_stiffness > c.cable.axial_stiffness * std::pow(kThickest * c.length, 2)) continue;
    ++count_;
    return c;
  }
}

}  // namespace cdpr_kinetostatics
