#include "robot/yaml_number.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <regex>
#include <sstream>
#include <vector>

namespace cdpr_kinetostatics {
namespace {

// Longer texts are no numbers [characters]. std::regex takes some hundred bytes of the stack for each character.
constexpr std::size_t kLongest = 400;

bool matches(const std::string& text, const std::regex& pattern) {
  return text.size() <= kLongest && std::regex_match(text, pattern);
}

std::string withoutUnderscores(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  return text;
}

// Digits, point and exponent, in any locale. Beyond the largest double: infinity.
double parse(const std::string& digits) {
  std::istringstream stream(digits);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  return std::abs(value) >= std::numeric_limits<double>::max() ? std::copysign(HUGE_VAL, value) : value;
}

double parseWhole(const std::string& digits, int base) {
  double value = 0.0;
  for (const char c : digits) {
    const int digit = c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
    value = base * value + digit;
  }
  return value;
}

// 1:30 is 90: hours, minutes and seconds, in any number.
double parseSexagesimal(const std::string& text) {
  std::vector<double> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(parse(part));
  double value = 0.0;
  double base = 1.0;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part, base *= 60.0) value += *part * base;
  return value;
}

struct Signed {
  double sign;
  std::string digits;
};

Signed splitSign(const std::string& text) {
  const bool has_sign = text[0] == '-' || text[0] == '+';
  return {text[0] == '-' ? -1.0 : 1.0, has_sign ? text.substr(1) : text};
}

}  // namespace

// The patterns are those of PyYAML's resolver.
std::optional<double> readWholeNumber(const std::string& text) {
  static const std::regex kPattern(
      "[-+]?0b[0-1_]+|[-+]?0[0-7_]+|[-+]?(?:0|[1-9][0-9_]*)|[-+]?0x[0-9a-fA-F_]+|[-+]?[1-9][0-9_]*(?::[0-5]?[0-9])+");
  if (!matches(text, kPattern)) return std::nullopt;
  const auto [sign, digits] = splitSign(withoutUnderscores(text));
  const std::string prefix = digits.substr(0, 2);
  if (prefix == "0b" || prefix == "0x") {
    if (digits.size() == 2) return std::nan("");
    return sign * parseWhole(digits.substr(2), prefix == "0b" ? 2 : 16);
  }
  if (digits[0] == '0') return sign * parseWhole(digits, 8);
  if (digits.find(':') != std::string::npos) return sign * parseSexagesimal(digits);
  return sign * parse(digits);
}

std::optional<double> readPointNumber(const std::string& text) {
  static const std::regex kPattern(
      "[-+]?[0-9][0-9_]*\\.[0-9_]*(?:[eE][-+][0-9]+)?|\\.[0-9][0-9_]*(?:[eE][-+][0-9]+)?"
      "|[-+]?[0-9][0-9_]*(?::[0-5]?[0-9])+\\.[0-9_]*|[-+]?\\.(?:inf|Inf|INF)|\\.(?:nan|NaN|NAN)");
  if (!matches(text, kPattern)) return std::nullopt;
  const auto [sign, digits] = splitSign(withoutUnderscores(text));
  if (digits[0] == '.' && (digits[1] == 'i' || digits[1] == 'I')) return sign * HUGE_VAL;
  if (digits[0] == '.' && (digits[1] == 'n' || digits[1] == 'N')) return std::nan("");
  if (digits.find(':') != std::string::npos) return sign * parseSexagesimal(digits);
  return sign * parse(digits);
}

std::optional<double> readDecimal(const std::string& text) {
  static const std::regex kZeros("[-+]?0[0-9].*");
  return matches(text, kZeros) ? std::nullopt : readPythonFloat(text);
}

std::optional<double> readPythonFloat(const std::string& text) {
  static const std::regex kPattern("[-+]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][-+]?[0-9]+)?");
  if (!matches(text, kPattern)) return std::nullopt;
  const auto [sign, digits] = splitSign(text);
  return sign * parse(digits);
}

}  // namespace cdpr_kinetostatics
