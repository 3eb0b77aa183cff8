// Wall-clock times of repeated calls, as the benchmarks report them.
#pragma once

#include <vector>

namespace cdpr_kinetostatics {

// Seconds since an arbitrary moment; never goes back.
double now();

// The value that a share of the sorted values lies below, 0 <= share <= 1 (0.5: median, 0.99: p99); interpolated.
double quantile(std::vector<double> values, double share);

// Prevents the compiler from dropping the computation of value.
template <typename T>
void keep(const T& value) {
  asm volatile("" : : "r,m"(&value) : "memory");
}

}  // namespace cdpr_kinetostatics
