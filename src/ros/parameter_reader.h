// Reads a struct of parameters value by value, checks each, and remembers what was never asked for.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <optional>
#include <string>
#include <vector>

namespace cdpr_kinetostatics {

// The number that a parameter holds. YAML 1.1 reads 1e-8, which has no point, as a string; so a string that is nothing
// but a number counts as that number.
std::optional<double> asNumber(const XmlRpc::XmlRpcValue& value);

// A wrong value throws std::invalid_argument, whose text names the key, the value and what was expected.
// A missing one is the fallback.
class ParameterReader {
 public:
  // `where` goes before each key in texts, as "~" or "~faults[0]/".
  explicit ParameterReader(const XmlRpc::XmlRpcValue& values, std::string where = "~");

  bool has(const std::string& key);
  const XmlRpc::XmlRpcValue& value(const std::string& key);  // the key must be there

  double number(const std::string& key, double fallback, double low, double high, const char* unit);
  int integer(const std::string& key, int fallback, int low, int high);
  bool flag(const std::string& key, bool fallback);
  std::string word(const std::string& key, const std::string& fallback);
  std::string oneOf(const std::string& key, const std::string& fallback, const std::vector<std::string>& choices);
  // Exactly `count` numbers; empty if the key is missing.
  std::vector<double> numbers(const std::string& key, int count, double low, double high, const char* unit);

  [[noreturn]] void refuse(const std::string& key, const std::string& expected);
  // One sentence for each key that is there and was never asked for.
  std::vector<std::string> ignored() const;

 private:
  XmlRpc::XmlRpcValue values_;
  std::string where_;
  std::vector<std::string> asked_;
};

}  // namespace cdpr_kinetostatics
