#pragma once
// Arithmetic in the rules of a parametric L-system: l * 0.7, w > 0.1 and l < 3.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace verdigris {

/// A value that has a name.
using NamedNumber = std::pair<std::string, double>;

/// An expression made ready to be evaluated many times.
///
/// Operators from weak to strong: or, and, comparisons (< <= > >= == !=), + -, * /, minus, ^; brackets. What
/// is true is 1, what is false 0; anything but 0 counts as true.
class Expression {
 public:
  /// Its value for these parameters. Never throws; what has no value (1 / 0) is not finite.
  double operator()(std::span<const double> parameters) const;

 private:
  friend class ExpressionParser;
  enum class Code : std::uint8_t {
    number,
    parameter,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    unequal,
    both,
    either
  };
  struct Step {
    Code code;
    std::uint32_t parameter;
    double number;
  };
  std::vector<Step> steps_;  // in reverse Polish order; never deeper than most_deep
  static constexpr int most_deep = 32;
};

/// What is wrong with an expression, and at which character of it.
struct ExpressionFault {
  std::size_t offset;
  std::string problem, remedy;
};

/// Reads an expression in which `parameters` (by position) and `constants` may occur. Throws ExpressionFault.
Expression parse_expression(std::string_view text, std::span<const std::string> parameters,
                            std::span<const NamedNumber> constants);

}  // namespace verdigris
