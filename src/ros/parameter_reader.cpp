#include "ros/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cable/text.h"
#include "robot/yaml_number.h"

namespace cdpr_kinetostatics {

using XmlRpc::XmlRpcValue;

std::optional<double> asNumber(const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeInt:
      return static_cast<const int&>(value);
    case XmlRpcValue::TypeDouble:
      return static_cast<const double&>(value);
    case XmlRpcValue::TypeString:
      return readDecimal(static_cast<const std::string&>(value));
    default:
      return std::nullopt;
  }
}

ParameterReader::ParameterReader(const XmlRpcValue& values, std::string where)
    : values_(values), where_(std::move(where)) {}

bool ParameterReader::has(const std::string& key) {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.push_back(key);
  return values_.getType() == XmlRpcValue::TypeStruct && values_.hasMember(key);
}

const XmlRpcValue& ParameterReader::value(const std::string& key) { return values_[key]; }

void ParameterReader::refuse(const std::string& key, const std::string& expected) {
  std::ostringstream shown;
  if (!has(key)) {
    shown << "missing";
  } else if (value(key).getType() == XmlRpcValue::TypeString) {
    shown << "'" << static_cast<const std::string&>(value(key)) << "'";
  } else {
    value(key).write(shown);
  }
  throw std::invalid_argument(text("parameter ", where_, key, " is ", shown.str(), ": expected ", expected));
}

double ParameterReader::number(const std::string& key, double fallback, double low, double high, const char* unit) {
  if (!has(key)) return fallback;
  const std::optional<double> number = asNumber(value(key));
  if (!number || !(*number >= low && *number <= high)) {
    refuse(key, text("a number from ", low, " to ", high, unit));
  }
  return *number;
}

int ParameterReader::integer(const std::string& key, int fallback, int low, int high) {
  const double found = number(key, fallback, low, high, "");
  if (found != std::floor(found)) refuse(key, text("a whole number from ", low, " to ", high));
  return static_cast<int>(found);
}

bool ParameterReader::flag(const std::string& key, bool fallback) {
  if (!has(key)) return fallback;
  if (value(key).getType() != XmlRpcValue::TypeBoolean) refuse(key, "true or false");
  return static_cast<const bool&>(value(key));
}

std::string ParameterReader::word(const std::string& key, const std::string& fallback) {
  if (!has(key)) return fallback;
  if (value(key).getType() != XmlRpcValue::TypeString || static_cast<const std::string&>(value(key)).empty()) {
    refuse(key, "a word");
  }
  return static_cast<const std::string&>(value(key));
}

std::string ParameterReader::oneOf(const std::string& key, const std::string& fallback,
                                   const std::vector<std::string>& choices) {
  std::string expected;
  for (const std::string& choice : choices) expected += (expected.empty() ? "one of " : ", ") + choice;
  if (has(key) && value(key).getType() != XmlRpcValue::TypeString) refuse(key, expected);
  const std::string found = word(key, fallback);
  if (std::find(choices.begin(), choices.end(), found) == choices.end()) refuse(key, expected);
  return found;
}

std::vector<double> ParameterReader::numbers(const std::string& key, int count, double low, double high,
                                             const char* unit) {
  std::vector<double> found;
  if (!has(key)) return found;
  const XmlRpcValue& list = value(key);
  const std::string expected = text("a list of ", count, " numbers from ", low, " to ", high, unit);
  if (list.getType() != XmlRpcValue::TypeArray || list.size() != count) refuse(key, expected);
  for (int i = 0; i < count; ++i) {
    const std::optional<double> number = asNumber(list[i]);
    if (!number || !(*number >= low && *number <= high)) refuse(key, expected);
    found.push_back(*number);
  }
  return found;
}

std::vector<std::string> ParameterReader::ignored() const {
  std::vector<std::string> sentences;
  if (values_.getType() != XmlRpcValue::TypeStruct) return sentences;
  std::string known;
  for (const std::string& key : asked_) known += (known.empty() ? "" : ", ") + where_ + key;
  for (auto entry = values_.begin(); entry != values_.end(); ++entry) {
    if (std::find(asked_.begin(), asked_.end(), entry->first) != asked_.end()) continue;
    sentences.push_back(
        text("parameter ", where_, entry->first, " is unknown and ignored: the node's parameters are ", known));
  }
  return sentences;
}

}  // namespace cdpr_kinetostatics
