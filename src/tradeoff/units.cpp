#include "tradeoff/units.h"

#include <cstdio>

namespace cdpr_kinetostatics {
namespace {

struct Prefix {
  double factor;
  const char* name;
};
constexpr Prefix kPrefixes[] = {{1.0, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}, {1e-12, "p"}};
constexpr double kLeast = 1e-13;  // [m], [s]: smaller values are rounding

std::string withPrefix(double value, int digits, const char* unit) {
  if (value == 0.0) return std::string("0 ") + unit;
  if (value < kLeast) return std::string("<0.1 p") + unit;
  const Prefix* chosen = kPrefixes;
  while (chosen->factor > 1e-12 && value < 0.9995 * chosen->factor) ++chosen;
  char text[32];
  const double scaled = value / chosen->factor;
  if (scaled < 99.5) {
    std::snprintf(text, sizeof text, "%.*g %s%s", digits, scaled, chosen->name, unit);
  } else {
    std::snprintf(text, sizeof text, "%.0f %s%s", scaled, chosen->name, unit);
  }
  return text;
}

}  // namespace

std::string asLength(double metres) { return withPrefix(metres, 3, "m"); }
std::string asTime(double seconds) { return withPrefix(seconds, 2, "s"); }

}  // namespace cdpr_kinetostatics
