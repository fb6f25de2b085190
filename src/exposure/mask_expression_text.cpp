// The grammar of mask expressions: recursive descent, a function for each strength of operator.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "verdigris/base/error.hpp"
#include "verdigris/exposure/mask_expression.hpp"

namespace verdigris {

namespace {

using Code = MaskExpression::Code;

struct Function {
  std::string_view name;
  Code code;
  int arguments;  // 0: two or more
};
constexpr Function functions[] = {{"min", Code::least, 0},     {"max", Code::greatest, 0},
                                  {"clamp", Code::clamp, 3},   {"smoothstep", Code::smoothstep, 3},
                                  {"mix", Code::mix, 3},       {"step", Code::step, 2},
                                  {"pow", Code::power, 2},     {"abs", Code::absolute, 1},
                                  {"sqrt", Code::root, 1},     {"exp", Code::exponential, 1},
                                  {"log", Code::logarithm, 1}, {"sin", Code::sine, 1},
                                  {"cos", Code::cosine, 1},    {"floor", Code::floor, 1}};

}  // namespace

class MaskExpressionParser {
 public:
  MaskExpressionParser(std::string_view text, std::span<const std::string> names, std::string_view where,
                       MaskExpression& expression)
      : text_(text), names_(names), where_(where), expression_(expression) {}

  void parse() {
    sum();
    blanks();
    if (at_ != text_.size())
      fail(fmt::format("'{}' does not belong here", text_[at_]), "write an operator, or end the expression");
    auto& used = expression_.used_;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
  }

 private:
  static constexpr int most_nested = 100;

  [[noreturn]] void fail(std::string problem, std::string remedy) const { fail_at(at_, problem, remedy); }
  [[noreturn]] void fail_at(std::size_t at, const std::string& problem, const std::string& remedy) const {
    throw InputError(fmt::format("{}, column {}", where_, at + 1), problem, remedy);
  }

  void blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  bool take(char token) {
    blanks();
    if (at_ == text_.size() || text_[at_] != token) return false;
    ++at_;
    return true;
  }
  void push(Code code, float number = 0.0f, std::uint32_t mask = 0) {
    expression_.steps_.push_back({code, mask, number});
    const bool operand = code == Code::number || code == Code::mask;
    const bool unary = code == Code::negate || code >= Code::absolute;
    const bool ternary = code == Code::clamp || code == Code::smoothstep || code == Code::mix;
    deep_ = operand ? deep_ + 1 : unary ? deep_ : ternary ? deep_ - 2 : deep_ - 1;
    expression_.deepest_ = std::max(expression_.deepest_, deep_);
  }
  template <typename Inner>
  void nest(Inner&& inner) {
    if (++nested_ > most_nested) fail("the expression is nested too deeply", "make a mask of a part of it");
    inner();
    --nested_;
  }

  void sum() {
    product();
    for (;;) {
      if (take('+')) {
        product();
        push(Code::add);
      } else if (take('-')) {
        product();
        push(Code::subtract);
      } else {
        return;
      }
    }
  }
  void product() {
    negated();
    for (;;) {
      if (take('*')) {
        negated();
        push(Code::multiply);
      } else if (take('/')) {
        negated();
        push(Code::divide);
      } else {
        return;
      }
    }
  }
  void negated() {
    bool minus = false;
    while (take('-')) minus = !minus;
    power();
    if (minus) push(Code::negate);
  }
  void power() {
    operand();
    if (!take('^')) return;
    nest([&] { negated(); });
    push(Code::power);
  }

  void operand() {
    if (take('(')) {
      nest([&] { sum(); });
      if (!take(')')) fail("a bracket is not closed", "write ')'");
      return;
    }
    if (at_ == text_.size()) fail("a value is missing at the end", "write a number, a mask or a bracket");
    const auto c = static_cast<unsigned char>(text_[at_]);
    if (std::isalpha(c) || c == '_')
      name();
    else
      number();
  }

  void number() {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(static_cast<float>(value)))
      fail("there is no value here", "write a number, a mask or a bracket");
    at_ = static_cast<std::size_t>(end - text_.data());
    push(Code::number, static_cast<float>(value));
  }

  void name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_'))
      ++at_;
    const std::string_view word = text_.substr(begin, at_ - begin);
    blanks();
    const auto function = std::find_if(std::begin(functions), std::end(functions),
                                       [&](const Function& f) { return f.name == word; });
    if (function != std::end(functions) && at_ < text_.size() && text_[at_] == '(') {
      arguments(*function, begin);
      return;
    }
    const auto mask = std::find(names_.begin(), names_.end(), word);
    if (mask != names_.end()) {
      expression_.used_.push_back(static_cast<std::uint32_t>(mask - names_.begin()));
      push(Code::mask, 0.0f, expression_.used_.back());
      return;
    }
    if (word == "pi") {
      push(Code::number, std::numbers::pi_v<float>);
      return;
    }
    if (function != std::end(functions))
      fail(fmt::format("'{}' has no arguments", word), "write them in brackets after it");
    fail_at(begin, fmt::format("there is no mask named '{}'", word),
            names_.empty() ? "define it before" : fmt::format("use one of: {}", fmt::join(names_, ", ")));
  }

  void arguments(const Function& function, std::size_t begin) {
    take('(');
    int count = 0;
    do {
      nest([&] { sum(); });
      ++count;
      // More than two of them: one after the other.
      if (function.arguments == 0 && count > 1) push(function.code);
    } while (take(','));
    if (!take(')')) fail("the arguments are not closed", "write ',' or ')'");
    if (function.arguments == 0 ? count < 2 : count != function.arguments)
      fail_at(begin, fmt::format("{} arguments to '{}'", count, function.name),
              function.arguments == 0 ? "give two or more" : fmt::format("give {}", function.arguments));
    if (function.arguments != 0) push(function.code);
  }

  std::string_view text_;
  std::span<const std::string> names_;
  std::string_view where_;
  MaskExpression& expression_;
  std::size_t at_ = 0, deep_ = 0;
  int nested_ = 0;
};

MaskExpression::MaskExpression(std::string_view text, std::span<const std::string> names,
                               std::string_view where) {
  MaskExpressionParser(text, names, where, *this).parse();
}

}  // namespace verdigris
