// From the fuzzer's bytes to the numbers of a request: half of them are what a robot could have, the others anything
// that fits into a double, with the numbers among them that break programs.
#pragma once

#include <FuzzedDataProvider.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "cdpr_kinetostatics/cable/cable_properties.h"
#include "cdpr_kinetostatics/cable/model.h"

namespace cdpr_kinetostatics {

class FuzzedInput {
 public:
  FuzzedInput(const std::uint8_t* data, std::size_t size) : provider_(data, size) {}

  bool flag() { return provider_.ConsumeBool(); }
  int count(int least, int most) { return provider_.ConsumeIntegralInRange<int>(least, most); }

  // Between low and high, mostly; now and then any number.
  double number(double low, double high) {
    switch (provider_.ConsumeIntegralInRange<int>(0, 15)) {
      case 0:
        return anything();
      case 1:
        return special();
      case 2:
        return low;
      case 3:
        return high;
      default:
        return provider_.ConsumeFloatingPointInRange<double>(low, high);
    }
  }

  // A positive number whose magnitude is spread evenly between low and high, mostly.
  double magnitude(double low, double high) {
    if (provider_.ConsumeIntegralInRange<int>(0, 15) == 0) return flag() ? anything() : special();
    return std::exp(provider_.ConsumeFloatingPointInRange<double>(std::log(low), std::log(high)));
  }

  Model model() { return static_cast<Model>(provider_.ConsumeIntegralInRange<int>(static_cast<int>(Model::kAuto), 8)); }

  CableProperties cable() {
    CableProperties properties;
    properties.axial_stiffness = magnitude(1e2, 1e8);
    properties.bending_stiffness = flag() ? 0.0 : magnitude(1e-6, 1e4);
    properties.weight = flag() ? magnitude(1e-3, 1e2) : number(0.0, 10.0);
    if (flag()) properties.pulley = {magnitude(1e-3, 0.3), flag() ? RopeFrom::kBelow : RopeFrom::kAbove};
    if (flag()) properties.dead_length = number(0.0, 20.0);
    return properties;
  }

 private:
  double anything() {
    const auto bits = provider_.ConsumeIntegral<std::uint64_t>();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  double special() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr std::array<double, 12> kSpecial = {
        0.0,   -0.0, 1e-300, -1e-300,   1e300,      -1e300,
        1e-12, -1.0, 1e12,   kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
    return provider_.PickValueInArray(kSpecial);
  }

  FuzzedDataProvider provider_;
};

}  // namespace cdpr_kinetostatics
