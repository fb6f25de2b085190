#include "verdigris/synthesis/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace verdigris {

double Expression::operator()(std::span<const double> parameters) const {
  std::array<double, most_deep> stack;
  std::size_t top = 0;  // one past the last value
  for (const Step& step : steps_) {
    if (step.code == Code::number) {
      stack[top++] = step.number;
      continue;
    }
    if (step.code == Code::parameter) {
      stack[top++] = parameters[step.parameter];
      continue;
    }
    if (step.code == Code::negate) {
      stack[top - 1] = -stack[top - 1];
      continue;
    }
    const double b = stack[--top];
    double& a = stack[top - 1];
    switch (step.code) {
      case Code::add:
        a += b;
        break;
      case Code::subtract:
        a -= b;
        break;
      case Code::multiply:
        a *= b;
        break;
      case Code::divide:
        a /= b;
        break;
      case Code::power:
        a = std::pow(a, b);
        break;
      case Code::less:
        a = a < b;
        break;
      case Code::less_equal:
        a = a <= b;
        break;
      case Code::greater:
        a = a > b;
        break;
      case Code::greater_equal:
        a = a >= b;
        break;
      case Code::equal:
        a = a == b;
        break;
      case Code::unequal:
        a = a != b;
        break;
      case Code::both:
        a = a != 0.0 && b != 0.0;
        break;
      default:
        a = a != 0.0 || b != 0.0;
        break;
    }
  }
  return stack[0];
}

// Recursive descent, a function for each strength of operator.
class ExpressionParser {
 public:
  using Code = Expression::Code;

  ExpressionParser(std::string_view text, std::span<const std::string> parameters,
                   std::span<const NamedNumber> constants)
      : text_(text), parameters_(parameters), constants_(constants) {}

  Expression parse() {
    either();
    blanks();
    if (at_ != text_.size())
      fault(fmt::format("'{}' does not belong here", text_[at_]), "write an operator, or end the expression");
    return std::move(expression_);
  }

 private:
  [[noreturn]] void fault(std::string problem, std::string remedy) const {
    throw ExpressionFault{at_, std::move(problem), std::move(remedy)};
  }

  void blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(std::string_view token) {
    blanks();
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }
  bool take_word(std::string_view word) {
    blanks();
    if (name() != word) return false;
    at_ += word.size();
    return true;
  }
  // The name that begins here; empty when none does.
  std::string_view name() const {
    std::size_t end = at_;
    while (end < text_.size() && (std::isalpha(static_cast<unsigned char>(text_[end])) || text_[end] == '_' ||
                                  (end > at_ && std::isdigit(static_cast<unsigned char>(text_[end])))))
      ++end;
    return text_.substr(at_, end - at_);
  }

  void push(Code code, double number = 0.0, std::uint32_t parameter = 0) {
    deep_ += code == Code::number || code == Code::parameter ? 1 : code == Code::negate ? 0 : -1;
    if (deep_ > Expression::most_deep)
      fault("the expression is nested too deeply", "split it over several rules");
    expression_.steps_.push_back({code, parameter, number});
  }

  void either() {
    both();
    while (take_word("or")) {
      both();
      push(Code::either);
    }
  }
  void both() {
    comparison();
    while (take_word("and")) {
      comparison();
      push(Code::both);
    }
  }
  void comparison() {
    sum();
    static constexpr std::pair<std::string_view, Code> tokens[] = {
        {"<=", Code::less_equal}, {">=", Code::greater_equal}, {"==", Code::equal},
        {"!=", Code::unequal},    {"<", Code::less},           {">", Code::greater}};
    for (const auto& [token, code] : tokens)
      if (take(token)) {
        sum();
        push(code);
        return;
      }
  }
  void sum() {
    product();
    for (;;) {
      const bool plus = take("+");
      if (!plus && !take("-")) return;
      product();
      push(plus ? Code::add : Code::subtract);
    }
  }
  void product() {
    negated();
    for (;;) {
      const bool times = take("*");
      if (!times && !take("/")) return;
      negated();
      push(times ? Code::multiply : Code::divide);
    }
  }
  void negated() {
    bool minus = false;
    while (take("-")) minus = !minus;
    power();
    if (minus) push(Code::negate);
  }
  void power() {
    operand();
    if (!take("^")) return;
    nest([&] { negated(); });
    push(Code::power);
  }

  // The parser itself must not nest without end either.
  template <typename Inner>
  void nest(Inner&& inner) {
    if (++nested_ > Expression::most_deep)
      fault("the expression is nested too deeply", "split it over several rules");
    inner();
    --nested_;
  }

  void operand() {
    blanks();
    if (take("(")) {
      nest([&] { either(); });
      if (!take(")")) fault("a bracket is not closed", "write ')'");
      return;
    }
    const std::string_view word = name();
    if (!word.empty()) {
      const auto parameter = std::find(parameters_.begin(), parameters_.end(), word);
      const auto constant = std::find_if(constants_.begin(), constants_.end(),
                                         [&](const NamedNumber& c) { return c.first == word; });
      if (parameter != parameters_.end())
        push(Code::parameter, 0.0, static_cast<std::uint32_t>(parameter - parameters_.begin()));
      else if (constant != constants_.end())
        push(Code::number, constant->second);
      else
        fault(fmt::format("there is no value named '{}'", word),
              "use a parameter of the rule, or define it before with `let`");
      at_ += word.size();
      return;
    }
    double number = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    if (error != std::errc() || !std::isfinite(number))
      fault(at_ == text_.size() ? "a value is missing at the end" : "there is no value here",
            "write a number, a name or a bracket");
    push(Code::number, number);
    at_ = static_cast<std::size_t>(end - text_.data());
  }

  std::string_view text_;
  std::span<const std::string> parameters_;
  std::span<const NamedNumber> constants_;
  Expression expression_;
  std::size_t at_ = 0;
  int deep_ = 0, nested_ = 0;
};

Expression parse_expression(std::string_view text, std::span<const std::string> parameters,
                            std::span<const NamedNumber> constants) {
  return ExpressionParser(text, parameters, constants).parse();
}

}  // namespace verdigris
