#pragma once
// Masks combined by a formula: "0.6 * wetness + 0.4 * (1 - ao)".

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"

namespace verdigris {

/// A formula over named masks, ready to be evaluated.
///
/// Operators from weak to strong: + -, * /, minus, ^ (binds to the right); brackets. Functions: min and max
/// of two or more, clamp(x, low, high), smoothstep(low, high, x), mix(a, b, share), step(edge, x), pow(a, b),
/// abs, sqrt, exp, log, sin, cos, floor. Constants: pi. What has no value (1 / 0, sqrt(-1)) comes out as 0.
class MaskExpression {
 public:
  /// Reads `text`, in which `names` may occur (letters, digits and _). Throws InputError naming `where` and
  /// the column for anything that is not such a formula.
  MaskExpression(std::string_view text, std::span<const std::string> names, std::string_view where);

  /// The names that occur, by their index in `names`, ascending.
  const std::vector<std::uint32_t>& used() const { return used_; }

  /// Its value in every slot. `masks` stand in the order of `names`; those that do not occur may be null.
  /// All are of one length: `slots`. The same bits for any number of threads.
  Field<float> evaluate(std::span<const Field<float>* const> masks, std::size_t slots) const;

  enum class Code : std::uint8_t {
    number,
    mask,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    least,
    greatest,
    clamp,
    smoothstep,
    mix,
    step,
    absolute,
    root,
    exponential,
    logarithm,
    sine,
    cosine,
    floor
  };

 private:
  friend class MaskExpressionParser;
  struct Step {
    Code code;
    std::uint32_t mask;
    float number;
  };
  std::vector<Step> steps_;  // in reverse Polish order
  std::vector<std::uint32_t> used_;
  std::size_t deepest_ = 0;  // values on the stack at once
};

}  // namespace verdigris
