// Wall-clock times of repeated calls, as the benchmarks report them.
#pragma once

#include <vector>

namespace cdpr_kinetostatics {

// Seconds since an arbitrary moment; never goes back.
double now();

// The value below which this share of the sorted values lies (0.5: median, 0.99: p99), interpolated between two of
// them.
double quantile(std::vector<double> values, double share);

// Prevents the compiler from dropping the computation of value.
template <typename T>
void keep(const T& value) {
  asm volatile("" : : "r,m"(&value) : "memory");
}

}  // namespace cdpr_kinetostatics
