// Words grow as their grammars say, and what is no grammar is refused with its place.

#include "verdigris/synthesis/lsystem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verdigris/base/error.hpp"

namespace verdigris {
namespace {

Word after(const std::string& text, int iterations, std::uint64_t seed = 1) {
  return rewrite(parse_lsystem(text, "test").grammar, iterations, seed);
}

// The message of the InputError that `text` causes; empty when it causes none.
std::string refusal(const std::string& text) {
  try {
    parse_lsystem(text, "plant.txt");
  } catch (const InputError& error) {
    EXPECT_FALSE(error.remedy().empty()) << error.what();
    return error.what();
  }
  return "";
}

TEST(LSystem, AlgaeGiveFibonacciNumbers) {
  const LSystem algae = named_lsystem("algae");
  std::size_t before = 1, now = 1;
  for (int n = 1; n <= 25; ++n) {
    const Word word = rewrite(algae.grammar, n, 1);
    EXPECT_EQ(word.size(), now) << n;
    std::swap(before, now);
    now += before;
  }
  EXPECT_EQ(word_text(rewrite(algae.grammar, 4, 1)), "ABBAB");
}

TEST(LSystem, RewritesAllSymbolsAtOnceAndKeepsOthers) {
  EXPECT_EQ(word_text(after("axiom = F\nF -> F-F++F-F\n", 1)), "F-F++F-F");
  EXPECT_EQ(word_text(after("axiom = A B\nA -> B\nB -> A  # swapped\n", 1)), "BA");
  EXPECT_EQ(word_text(after("axiom = AXA\nX ->\n", 1)), "AA");
  EXPECT_EQ(after("axiom = F\nF -> F-F++F-F\n", 6).size(), 4096u + 4095u / 3u * 4u);
}

TEST(LSystem, ParametersConditionsAndConstants) {
  const std::string text =
      "let r = 1 / 2\naxiom = A(4, 1)\n"
      "A(l, w) if l > 1 and w != 0 -> F(l)[+(30)A(l * r, w)]\nA(l, w) if l <= 1 -> B\n";
  EXPECT_EQ(word_text(after(text, 1)), "F(4)[+(30)A(2,1)]");
  EXPECT_EQ(word_text(after(text, 3)), "F(4)[+(30)F(2)[+(30)B]]");
  EXPECT_EQ(word_text(after("axiom = A(2)\nA(x) -> A(-x ^ 2 + 3 * (x - 1))\n", 1)), "A(-1)");
  EXPECT_EQ(word_text(after("axiom = A(2)\nA(x) -> A(2 ^ 3 ^ 0 - 10 / 4 / 5)\n", 1)), "A(1.5)");
  // A rule applies to symbols with as many values as it has parameters.
  EXPECT_EQ(word_text(after("axiom = A A(1)\nA -> B\n", 1)), "BA(1)");
}

TEST(LSystem, WeightsAreShares) {
  const std::string text = "axiom = X\nX -> XX\nF @ 3 -> A\nF @ 1 -> B\n";
  LSystem system = parse_lsystem(text, "test");
  system.grammar.axiom.symbols.assign(100000, 'F');
  const Word word = rewrite(system.grammar, 1, 5);
  const auto a = std::count(word.symbols.begin(), word.symbols.end(), 'A');
  EXPECT_NEAR(static_cast<double>(a), 75000.0, 4.0 * std::sqrt(100000.0 * 0.75 * 0.25));
}

TEST(LSystem, TheSeedMakesTheWord) {
  const LSystem plant = named_lsystem("stochastic-plant");
  const std::string one = word_text(rewrite(plant.grammar, 5, 1));
  EXPECT_EQ(one, word_text(rewrite(plant.grammar, 5, 1)));
  EXPECT_NE(one, word_text(rewrite(plant.grammar, 5, 2)));
}

TEST(LSystem, GrowthIsCapped) {
  const LSystem doubling = parse_lsystem("axiom = F\nF -> FF\n", "test");
  EXPECT_EQ(rewrite(doubling.grammar, 20, 1).size(), std::size_t{1} << 20);
  EXPECT_THROW(rewrite(doubling.grammar, 1000, 1), InputError);
  EXPECT_THROW(rewrite(doubling.grammar, 11, 1, {.most = 1000}), InputError);
  // Values count too, and so do many iterations of words that do not grow.
  const LSystem wide = parse_lsystem("axiom = A(1,1)\nA(x,y) -> A(x,y)A(x,y)\n", "test");
  EXPECT_THROW(rewrite(wide.grammar, 9, 1, {.most = 1000}), InputError);
  const LSystem idle = parse_lsystem("axiom = ABCDEFGHIJ\nA -> B\n", "test");
  EXPECT_THROW(rewrite(idle.grammar, 1000, 1, {.most = 1000, .most_in_all = 5000}), InputError);
  // What is not finite is refused, not drawn.
  const LSystem inverse = parse_lsystem("axiom = F(1)\nF(x) -> F(1 / (x - 1))\n", "test");
  EXPECT_THROW(rewrite(inverse.grammar, 1, 1), InputError);
}

TEST(LSystem, FaultsAreSaidWithLineAndColumn) {
  const auto expect = [](const std::string& text, const std::string& place) {
    EXPECT_EQ(refusal(text).substr(0, place.size()), place) << text << "\n" << refusal(text);
  };
  expect("", "plant.txt: there is no axiom");
  expect("axiom =\n", "plant.txt:1:8: ");
  expect("axiom = F\naxiom = G\n", "plant.txt:2:1: ");
  expect("axiom = F\nF\n", "plant.txt:2:1: neither");
  expect("axiom = F\nF -> F[+F\n", "plant.txt:2:7: '['");
  expect("axiom = F\nF -> F]+F[\n", "plant.txt:2:7: ']'");
  expect("axiom = F\n  FF -> F\n", "plant.txt:2:4: ");
  expect("axiom = F\nF(x -> F(x)\n", "plant.txt:2:2: the bracket");
  expect("axiom = F(1)\nF(x) -> F(y)\n", "plant.txt:2:11: there is no value named 'y'");
  expect("axiom = F(1)\nF(x) -> F(x *)\n", "plant.txt:2:14: ");
  expect("axiom = F(1)\nF(x) -> F(x x)\n", "plant.txt:2:13: ");
  expect("axiom = F(1)\nF(2) -> F\n", "plant.txt:2:");
  expect("axiom = F(1)\nF(x) if x > -> F\n", "plant.txt:2:13: ");
  expect("axiom = F\nF @ -1 -> F\n", "plant.txt:2:5: ");
  expect("axiom = F\nF -> F\nF -> FF\n", "plant.txt:3:1: F has a rule already in line 2");
  expect("axiom = F\nangel = 20\n", "plant.txt:2:1: there is no setting");
  expect("axiom = F\nangle = steep\n", "plant.txt:2:9: ");
  expect("axiom = F\nangle = 500\n", "plant.txt:2:9: ");
  expect("axiom = F\niterations = 2.5\n", "plant.txt:2:14: ");
  expect("axiom = F\nlet 2x = 1\n", "plant.txt:2:1: ");
  expect("axiom = F\nF -> F\xC3\xA9\n", "plant.txt:2:7: ");
  expect(std::string("axiom = F\nF -> F\0G\n", 18), "plant.txt:2:7: ");
  expect("axiom = F(1,2,3,4,5,6,7,8,9)\n", "plant.txt:1:10: too many");
  expect("axiom = F(" + std::string(100, '(') + "1" + std::string(100, ')') + ")\n", "plant.txt:1:");
  expect(std::string(2 << 20, '#'), "plant.txt: ");
}

TEST(LSystem, NoTextHangsOrCrashes) {
  // Fragments of grammars put together at random: each is read or refused.
  const std::string parts[] = {"axiom", " = ", "F",    "->",  "[",  "]",     "(", ")", "1",
                               "x",     ",",   "if ",  "@",   "\n", "let ",  "+", "-", "*",
                               "^",     ">",   "and ", "or ", "#",  "angle", ".5"};
  std::uint32_t state = 1;
  for (int n = 0; n < 20000; ++n) {
    std::string text;
    for (int k = 0; k < 24; ++k) {
      state = state * 1664525u + 1013904223u;
      text += parts[(state >> 16) % std::size(parts)];
    }
    refusal(text);
  }
}

TEST(LSystem, PresetsAreReadAndKeepWithinBounds) {
  for (const LSystemPreset& preset : lsystem_presets()) {
    SCOPED_TRACE(preset.name);
    const LSystem system = named_lsystem(preset.name);
    EXPECT_FALSE(std::string(preset.summary).empty());
    const Word word = rewrite(system.grammar, system.iterations, 1);
    EXPECT_LT(word.size(), 500000u);
    EXPECT_FALSE(draw_word(word, system.turtle).empty());
  }
  EXPECT_THROW(named_lsystem("oak"), InputError);
}

}  // namespace
}  // namespace verdigris
