#include "extreme_cables.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <random>

namespace cdpr_kinetostatics {
namespace {

enum Dimension { kChord, kInclination, kForce, kStrain, kLoad, kLayers, kDimensions };

// Radius of gyration over length: from the first on a rod longer than its chord is shortened by a tenth before it bows,
// from the second on it is no rod.
constexpr double kThick = 0.1;
constexpr double kBlock = 0.5;

// Shares in (0, 1): every dimension has exactly one value in each of count equal intervals.
std::array<std::vector<double>, kDimensions> latinHypercube(int count) {
  std::mt19937 generator(19960229);
  const auto below = [&](double end) { return end * (static_cast<double>(generator()) / 4294967296.0); };
  std::array<std::vector<double>, kDimensions> shares;
  for (std::vector<double>& dimension : shares) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (int i = count - 1; i > 0; --i) std::swap(order[i], order[static_cast<int>(below(i + 1.0))]);
    for (const int interval : order) dimension.push_back((interval + below(1.0)) / count);
  }
  return shares;
}

double logarithmic(double low, double high, double share) { return low * std::pow(high / low, share); }

}  // namespace

std::string ExtremeCable::corner() const {
  const double thickness = std::sqrt(cable.bending_stiffness / cable.axial_stiffness) / length;
  if (thickness > kBlock) return "thicker than long";
  if (!taut && thickness > kThick) return "crushed";
  return "";
}

std::ostream& operator<<(std::ostream& out, const ExtremeCable& c) {
  return out << std::setprecision(17) << "{" << c.cable.axial_stiffness << ", " << c.cable.bending_stiffness << ", "
             << c.cable.weight << "}, L " << c.length << ", x " << c.x << ", y " << c.y << " (L/chord - 1 "
             << std::setprecision(4) << c.length / c.chord - 1.0 << ", kappa L " << c.layers << ", strain " << c.strain
             << ", weight " << c.weight << ", inclination " << c.inclination << ")";
}

std::vector<ExtremeCable> extremeCables(int count) {
  const std::array<std::vector<double>, kDimensions> shares = latinHypercube(count);
  std::vector<ExtremeCable> cables(count);
  for (int i = 0; i < count; ++i) {
    ExtremeCable& c = cables[i];
    const bool vertical = (i / 2) % 8 == 0;
    const bool weightless = (i / 2) % 8 == 1;
    c.taut = i % 2 == 0;
    c.chord = logarithmic(1e-3, 1e4, shares[kChord][i]);
    c.inclination = M_PI * (shares[kInclination][i] - 0.5);
    if (vertical) c.inclination = std::copysign(0.5 * M_PI, c.inclination);
    c.x = vertical ? 0.0 : c.chord * std::cos(c.inclination);
    c.y = vertical ? std::copysign(c.chord, c.inclination) : c.chord * std::sin(c.inclination);
    c.force = logarithmic(1e-3, 1e7, shares[kForce][i]);
    c.strain = logarithmic(1e-7, 5e-2, shares[kStrain][i]);
    c.layers = logarithmic(1e-2, 1e6, shares[kLayers][i]);
    if (c.taut) {
      c.weight = weightless ? 0.0 : std::pow(shares[kLoad][i], 2);
      c.length = c.chord / (1.0 + c.strain);
    } else {
      c.weight = 1.0;
      c.length = c.chord * (1.0 + logarithmic(1e-6, 4.0, shares[kLoad][i]));
    }
    c.cable.axial_stiffness = c.force / c.strain;
    c.cable.bending_stiffness = c.force * std::pow(c.length / c.layers, 2);
    c.cable.weight = c.weight * c.force / c.length;
  }
  return cables;
}

}  // namespace cdpr_kinetostatics
