#include "robot/angle_expression.h"

#include <cctype>

#include "robot/yaml_number.h"

namespace cdpr_kinetostatics {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kDeepest = 50;  // parentheses and signs within each other

// Each function reads what its name says from the front of what is left. After a mistake `failed_` stays set.
class Expression {
 public:
  explicit Expression(const std::string& text) : text_(text) {}

  std::optional<double> value() {
    const double sum = readSum();
    if (next() != '\0') failed_ = true;
    return failed_ ? std::nullopt : std::optional<double>(sum);
  }

 private:
  // The next character that is no space; 0 at the end.
  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  bool take(char wanted) {
    if (next() != wanted) return false;
    ++at_;
    return true;
  }

  double readSum() {
    double sum = readProduct();
    while (!failed_) {
      if (take('+')) {
        sum += readProduct();
      } else if (take('-')) {
        sum -= readProduct();
      } else {
        break;
      }
    }
    return sum;
  }

  double readProduct() {
    double product = readSigned();
    while (!failed_) {
      if (take('*')) {
        product *= readSigned();
      } else if (take('/')) {
        product /= readSigned();
      } else {
        break;
      }
    }
    return product;
  }

  double readSigned() {
    if (++depth_ > kDeepest) failed_ = true;
    double value = 0.0;
    if (!failed_) {
      if (take('-')) {
        value = -readSigned();
      } else if (take('+')) {
        value = readSigned();
      } else {
        value = readOperand();
      }
    }
    --depth_;
    return value;
  }

  double readOperand() {
    if (take('(')) {
      const double inside = readSum();
      if (!take(')')) failed_ = true;
      return inside;
    }
    const std::size_t start = at_;
    const auto belongs = [&](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.'; };
    const auto isExponentSign = [&] {
      const bool after_e = at_ > start && (text_[at_ - 1] == 'e' || text_[at_ - 1] == 'E');
      return after_e && (text_[at_] == '+' || text_[at_] == '-');
    };
    while (at_ < text_.size() && (belongs(text_[at_]) || isExponentSign())) ++at_;
    const std::string word = text_.substr(start, at_ - start);
    if (word == "pi") return kPi;
    const std::optional<double> number = readDecimal(word);
    if (!number) failed_ = true;
    return number.value_or(0.0);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool failed_ = false;
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::optional<double> degreesToRadians(const std::string& number) {
  const std::optional<double> degrees = readPythonFloat(trimmed(number));
  if (!degrees) return std::nullopt;
  return *degrees * kPi / 180.0;  // in this order, as roslaunch does: the same number to the last bit
}

std::optional<double> evaluateRadians(const std::string& expression) { return Expression(expression).value(); }

}  // namespace cdpr_kinetostatics
