#pragma once
// Lindenmayer's rewriting: all symbols of a word are replaced at once, by rules that may have parameters,
// conditions and weights.
// Sources: Lindenmayer 1968, "Mathematical models for cellular interactions in development"; Prusinkiewicz &
// Lindenmayer 1990, "The Algorithmic Beauty of Plants" (ABOP), 1.2, 1.7 (stochastic), 1.10 (parametric).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verdigris/synthesis/expression.hpp"

namespace verdigris {

/// A row of symbols, each with its values: A(1, 0.5) F [ + F ].
struct Word {
  std::string symbols;
  std::vector<double> values;       ///< of all symbols, one after the other
  std::vector<std::uint32_t> ends;  ///< [symbol] one past its last value; empty when no symbol has any

  std::size_t size() const { return symbols.size(); }
  std::span<const double> arguments(std::size_t k) const {
    if (ends.empty()) return {};
    const std::uint32_t begin = k == 0 ? 0 : ends[k - 1];
    return {values.data() + begin, ends[k] - begin};
  }
};

/// A symbol of a rule's right side, its values computed from those of the left.
struct SymbolTemplate {
  char symbol;
  std::vector<Expression> arguments;
};

/// `symbol(parameters) if condition @ weight -> successor`.
struct Production {
  char symbol = 0;
  std::size_t parameters = 0;           ///< applies to symbols with so many values
  std::optional<Expression> condition;  ///< and only where this holds
  double weight = 1.0;                  ///< of several rules that apply, one is drawn in this proportion
  std::vector<SymbolTemplate> successor;
  std::size_t values = 0;  ///< of all its successor's symbols
};

/// What a word starts as and how it is rewritten. Symbols without a rule that applies stay as they are.
struct Grammar {
  Word axiom;
  std::vector<Production> productions;
};

/// Words grow by powers: where to stop. Symbols and values count alike.
struct RewriteLimits {
  std::size_t most = 10'000'000;          ///< of one word
  std::size_t most_in_all = 200'000'000;  ///< of the words of all iterations together
};

/// The word after so many iterations. Which rule is drawn depends on (seed, iteration, position) only. Throws
/// InputError before a word is made that would pass the limits, and for values that are not finite.
Word rewrite(const Grammar& grammar, int iterations, std::uint64_t seed, const RewriteLimits& limits = {});

/// The word as one would write it.
std::string word_text(const Word& word);

}  // namespace verdigris
