#include "verdigris/synthesis/grammar.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "random_words.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t unchanged = 0xFFFFFFFFu;
constexpr std::uint32_t rule_purpose = 0x4C53u;

// The rules of each symbol, and which of them applies where.
class Rules {
 public:
  Rules(const Grammar& grammar, std::uint64_t seed) : productions_(grammar.productions), seed_(seed) {
    for (std::uint32_t k = 0; k < productions_.size(); ++k)
      of_symbol_[static_cast<unsigned char>(productions_[k].symbol)].push_back(k);
  }

  std::uint32_t choose(const Word& word, std::size_t position, int iteration) const {
    const auto& rules = of_symbol_[static_cast<unsigned char>(word.symbols[position])];
    if (rules.empty()) return unchanged;
    const std::span<const double> values = word.arguments(position);
    double total = 0.0;
    std::uint32_t last = unchanged;
    int applying = 0;
    for (const std::uint32_t k : rules)
      if (applies(productions_[k], values)) {
        total += productions_[k].weight;
        last = k;
        ++applying;
      }
    if (applying < 2) return last;
    const auto words = synthesis::random_words(seed_, static_cast<std::uint32_t>(position),
                                               static_cast<std::uint32_t>(iteration), rule_purpose);
    double rest = total * (static_cast<double>(words[0]) + 0.5) / 4294967296.0;
    for (const std::uint32_t k : rules)
      if (applies(productions_[k], values)) {
        rest -= productions_[k].weight;
        if (rest < 0.0) return k;
      }
    return last;
  }

 private:
  static bool applies(const Production& p, std::span<const double> values) {
    return p.parameters == values.size() && (!p.condition || (*p.condition)(values) != 0.0);
  }

  std::span<const Production> productions_;
  std::uint64_t seed_;
  std::array<std::vector<std::uint32_t>, 256> of_symbol_;
};

void append(const Production& p, std::span<const double> from, int iteration, Word& to) {
  for (const SymbolTemplate& symbol : p.successor) {
    to.symbols.push_back(symbol.symbol);
    for (const Expression& argument : symbol.arguments) {
      const double value = argument(from);
      if (!std::isfinite(value))
        throw InputError(
            fmt::format("rule of {}", p.symbol),
            fmt::format("iteration {} gives {} a value that is not finite", iteration + 1, symbol.symbol),
            "keep divisors away from 0 and factors below 1, or rewrite fewer times");
      to.values.push_back(value);
    }
  }
}

}  // namespace

Word rewrite(const Grammar& grammar, int iterations, std::uint64_t seed, const RewriteLimits& limits) {
  const Rules rules(grammar, seed);
  bool parametric = !grammar.axiom.ends.empty();
  for (const Production& p : grammar.productions) parametric = parametric || p.values > 0;

  Word word = grammar.axiom;
  std::size_t in_all = 0;
  std::vector<std::uint32_t> choice;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    // First how long the next word is, then the word.
    choice.resize(word.size());
    std::size_t symbols = 0, values = 0;
    for (std::size_t k = 0; k < word.size(); ++k) {
      choice[k] = rules.choose(word, k, iteration);
      const Production* p = choice[k] == unchanged ? nullptr : &grammar.productions[choice[k]];
      symbols += p ? p->successor.size() : 1;
      values += p ? p->values : word.arguments(k).size();
    }
    in_all += symbols + values + 1;
    if (symbols + values > limits.most || in_all > limits.most_in_all)
      throw InputError("iterations",
                       fmt::format("after {} of {} the word would have {} symbols and values", iteration + 1,
                                   iterations, symbols + values),
                       fmt::format("rewrite {} times; words of up to {} are made", iteration, limits.most));
    Word next;
    next.symbols.reserve(symbols);
    next.values.reserve(values);
    if (parametric) next.ends.reserve(symbols);
    for (std::size_t k = 0; k < word.size(); ++k) {
      const std::span<const double> from = word.arguments(k);
      if (choice[k] == unchanged) {
        next.symbols.push_back(word.symbols[k]);
        next.values.insert(next.values.end(), from.begin(), from.end());
        if (parametric) next.ends.push_back(static_cast<std::uint32_t>(next.values.size()));
        continue;
      }
      const Production& p = grammar.productions[choice[k]];
      auto end = static_cast<std::uint32_t>(next.values.size());
      append(p, from, iteration, next);
      if (parametric)
        for (const SymbolTemplate& symbol : p.successor) {
          end += static_cast<std::uint32_t>(symbol.arguments.size());
          next.ends.push_back(end);
        }
    }
    word = std::move(next);
  }
  return word;
}

std::string word_text(const Word& word) {
  std::string text;
  for (std::size_t k = 0; k < word.size(); ++k) {
    text += word.symbols[k];
    const std::span<const double> values = word.arguments(k);
    if (!values.empty()) text += fmt::format("({})", fmt::join(values, ","));
  }
  return text;
}

}  // namespace verdigris
