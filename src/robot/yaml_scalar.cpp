#include "robot/yaml_scalar.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "robot/angle_expression.h"
#include "robot/yaml_number.h"

namespace cdpr_kinetostatics {
namespace {

using Kind = YamlScalar::Kind;

constexpr double kMostWhole = 2147483648.0;  // whole numbers of ROS parameters are int32: less than 2^31
constexpr std::size_t kLongestDate = 40;     // characters
constexpr std::size_t kLongestQuote = 60;    // characters of a wrong value that a message repeats

YamlScalar refused(const std::string& expected) {
  YamlScalar scalar;
  scalar.kind = Kind::kRefused;
  scalar.text = expected;
  return scalar;
}

YamlScalar textScalar(const std::string& text) {
  YamlScalar scalar;
  scalar.kind = Kind::kText;
  scalar.text = text;
  return scalar;
}

YamlScalar numberScalar(Kind kind, double number) {
  YamlScalar scalar;
  scalar.kind = kind;
  scalar.number = number;
  return scalar;
}

// ROS passes whole numbers of 32 bits on and roslaunch refuses larger ones, so that a modulus of 200000000000 has one
// meaning: that of 2.0e+11.
YamlScalar wholeScalar(double number) {
  if (std::isnan(number)) return refused("digits after 0x or 0b");
  const bool fits = number >= -kMostWhole && number < kMostWhole;
  return numberScalar(fits ? Kind::kWholeNumber : Kind::kNumber, number + 0.0);  // without the sign of -0
}

YamlScalar angleScalar(const std::optional<double>& angle) {
  if (angle) return numberScalar(Kind::kNumber, *angle);
  return refused("an angle: deg(...) of a number, or rad(...) of numbers and pi with + - * / and parentheses");
}

bool isDate(const std::string& text) {
  static const std::regex kPattern(
      "[0-9]{4}-[0-9]{2}-[0-9]{2}|[0-9]{4}-[0-9]{1,2}-[0-9]{1,2}(?:[Tt]|[ \\t]+)[0-9]{1,2}:[0-9]{2}:[0-9]{2}"
      "(?:\\.[0-9]*)?(?:[ \\t]*(?:Z|[-+][0-9]{1,2}(?::[0-9]{2})?))?");
  return text.size() <= kLongestDate && std::regex_match(text, kPattern);
}

// Between "deg(" or "rad(" and the only closing parenthesis, at the end.
std::optional<std::string> argumentOf(const std::string& function, const std::string& text) {
  if (text.rfind(function + "(", 0) != 0 || text.find(')') != text.size() - 1) return std::nullopt;
  return text.substr(function.size() + 1, text.size() - function.size() - 2);
}

YamlScalar readFlag(const std::string& text) {
  static const std::set<std::string> kTrue = {"yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON"};
  static const std::set<std::string> kFalse = {"no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF"};
  if (kTrue.count(text) + kFalse.count(text) == 0) return textScalar(text);
  YamlScalar scalar;
  scalar.kind = Kind::kFlag;
  scalar.flag = kTrue.count(text) > 0;
  return scalar;
}

// Without quotes and without a tag.
YamlScalar readPlain(const std::string& text) {
  static const std::set<std::string> kNothing = {"", "~", "null", "Null", "NULL"};
  if (kNothing.count(text) > 0) return {};
  if (const auto number = readPointNumber(text)) return numberScalar(Kind::kNumber, *number);
  if (const auto number = readWholeNumber(text)) return wholeScalar(*number);
  if (const auto degrees = argumentOf("deg", text)) return angleScalar(degreesToRadians(*degrees));
  if (const auto radians = argumentOf("rad", text)) return angleScalar(evaluateRadians(*radians));
  if (text == "=" || text == "<<") return refused("a value");
  if (isDate(text)) return refused("no date, unless it is in quotes");
  return readFlag(text);
}

YamlScalar readTagged(const std::string& tag, const std::string& text) {
  const std::string yaml = "tag:yaml.org,2002:";
  if (tag == "!degrees") return angleScalar(degreesToRadians(argumentOf("deg", text).value_or(text)));
  if (tag == "!radians") return angleScalar(evaluateRadians(argumentOf("rad", text).value_or(text)));
  if (tag == yaml + "str") return textScalar(text);
  if (tag == yaml + "int") {
    if (const auto number = readWholeNumber(text)) return wholeScalar(*number);
    return refused("a whole number");
  }
  if (tag == yaml + "float") {
    const auto number = readPointNumber(text);
    if (const auto value = number ? number : readPythonFloat(text)) return numberScalar(Kind::kNumber, *value);
    return refused("a number");
  }
  if (tag == yaml + "bool") {
    const YamlScalar flag = readFlag(text);
    return flag.kind == Kind::kFlag ? flag : refused("true or false");
  }
  return refused("no tag, or one of !!str, !!int, !!float, !!bool, !degrees and !radians");
}

}  // namespace

YamlScalar readScalar(const YAML::Node& node) {
  if (node.IsNull()) return {};
  const std::string& tag = node.Tag();
  if (tag == "!") return textScalar(node.Scalar());  // in quotes
  const bool has_no_tag = tag.empty() || tag == "?";
  return has_no_tag ? readPlain(node.Scalar()) : readTagged(tag, node.Scalar());
}

std::optional<double> numberOf(const YamlScalar& scalar) {
  switch (scalar.kind) {
    case Kind::kWholeNumber:
    case Kind::kNumber:
      return scalar.number;
    case Kind::kText:
      return readDecimal(scalar.text);
    default:
      return std::nullopt;
  }
}

std::optional<std::string> wordOf(const YamlScalar& scalar) {
  if (scalar.kind == Kind::kText) return scalar.text;
  if (scalar.kind == Kind::kWholeNumber) return std::to_string(std::lround(scalar.number));
  return std::nullopt;
}

std::string quote(const YAML::Node& node) {
  if (node.IsNull()) return "nothing";
  YAML::Emitter emitter;
  emitter << YAML::Flow << node;
  std::string text = emitter.c_str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > kLongestQuote) text = text.substr(0, kLongestQuote) + "...";
  return text;
}

}  // namespace cdpr_kinetostatics
