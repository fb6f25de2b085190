#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "verdigris/behaviours/life.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

const std::vector<std::pair<std::string, std::string>>& life_rule_names() {
  static const std::vector<std::pair<std::string, std::string>> names{{"life", "B3/S23"},
                                                                      {"highlife", "B36/S23"},
                                                                      {"day & night", "B3678/S34678"},
                                                                      {"seeds", "B2/S"},
                                                                      {"maze", "B3/S12345"},
                                                                      {"mazectric", "B3/S1234"},
                                                                      {"coagulations", "B378/S235678"},
                                                                      {"amoeba", "B357/S1358"},
                                                                      {"replicator", "B1357/S1357"},
                                                                      {"diamoeba", "B35678/S5678"},
                                                                      {"life without death", "B3/S012345678"},
                                                                      {"2x2", "B36/S125"},
                                                                      {"anneal", "B4678/S35678"},
                                                                      {"morley", "B368/S245"},
                                                                      {"walled cities", "B45678/S2345"}};
  return names;
}

namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

[[noreturn]] void refuse(std::string_view text, std::string_view why) {
  std::string names;
  for (const auto& [name, rule] : life_rule_names()) {
    if (!names.empty()) names += ", ";
    names += name;
  }
  throw InputError(
      "rule", fmt::format("'{}' is no Life-like rule: {}", text, why),
      "write B3/S23, or 23/3 (survival first), with V behind it for four neighbours, or one of: " + names);
}

// Digits as a set of counts.
std::uint16_t counts(std::string_view text, std::string_view digits, int most) {
  std::uint16_t set = 0;
  for (const char c : digits) {
    if (c < '0' || c > '8') refuse(text, fmt::format("'{}' is no number of neighbours", c));
    if (c - '0' > most) refuse(text, fmt::format("a cell has only {} neighbours", most));
    set = static_cast<std::uint16_t>(set | 1u << (c - '0'));
  }
  return set;
}

}  // namespace

LifeRule parse_life_rule(std::string_view text) {
  std::string rest = lower(text);
  for (const auto& [name, rule] : life_rule_names())
    if (rest == name) rest = lower(rule);
  LifeRule rule;
  int most = 8;
  if (!rest.empty() && rest.back() == 'v') {
    rule.neighbourhood = LifeNeighbourhood::von_neumann;
    most = 4;
    rest.pop_back();
  }
  const auto slash = rest.find('/');
  if (slash == std::string::npos) refuse(text, "there is no slash in it");
  std::string_view first(rest.data(), slash), second(rest.data() + slash + 1, rest.size() - slash - 1);
  const bool first_named = !first.empty() && (first[0] == 'b' || first[0] == 's');
  const bool second_named = !second.empty() && (second[0] == 'b' || second[0] == 's');
  if (first_named != second_named) refuse(text, "only one half says which it is");
  // Without letters survival comes first.
  bool birth_first = false;
  if (first_named) {
    if (first[0] == second[0]) refuse(text, "both halves are the same");
    birth_first = first[0] == 'b';
    first.remove_prefix(1);
    second.remove_prefix(1);
  }
  rule.birth = counts(text, birth_first ? first : second, most);
  rule.survival = counts(text, birth_first ? second : first, most);
  return rule;
}

std::string life_rule_text(const LifeRule& rule) {
  const auto digits = [](std::uint16_t set) {
    std::string text;
    for (int n = 0; n <= 8; ++n)
      if ((set >> n & 1) != 0) text += static_cast<char>('0' + n);
    return text;
  };
  return fmt::format("B{}/S{}{}", digits(rule.birth), digits(rule.survival),
                     rule.neighbourhood == LifeNeighbourhood::von_neumann ? "V" : "");
}

}  // namespace verdigris
