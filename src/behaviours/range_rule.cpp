#include "verdigris/behaviours/range_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw InputError("rule", fmt::format("'{}' is no Larger-than-Life rule: {}", text, why),
                   "write R5,C0,M1,S34..58,B34..45,NM: range 1 to 10, two states, middle counted or not, "
                   "survival, birth, neighbourhood M (square), N (diamond) or C (disc)");
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0;;) {
    const std::size_t to = text.find(separator, from);
    parts.push_back(text.substr(from, to - from));
    if (to == std::string_view::npos) return parts;
    from = to + 1;
  }
}

unsigned number(std::string_view text, std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || value > 10000)
    refuse(text, fmt::format("'{}' is no number", digits));
  return value;
}

// "34..58", "6-9" or "7".
void include_counts(std::string_view text, std::string_view part, std::vector<std::uint8_t>& set) {
  if (part.empty()) return;
  std::size_t at = part.find(".."), width = 2;
  if (at == std::string_view::npos) {
    at = part.find('-');
    width = 1;
  }
  const bool single = at == std::string_view::npos;
  const unsigned from = number(text, part.substr(0, at)),
                 to = single ? from : number(text, part.substr(at + width));
  if (to >= set.size()) refuse(text, fmt::format("only {} cells are counted", set.size() - 1));
  if (from > to) refuse(text, fmt::format("'{}' runs backwards", part));
  std::fill(set.begin() + from, set.begin() + to + 1, std::uint8_t{1});
}

std::string intervals(const std::vector<std::uint8_t>& set) {
  std::string text;
  for (std::size_t from = 0; from < set.size(); ++from) {
    if (set[from] == 0) continue;
    std::size_t to = from;
    while (to + 1 < set.size() && set[to + 1] != 0) ++to;
    text += fmt::format("{}{}", text.empty() ? "" : ",", from);
    if (to > from) text += fmt::format("-{}", to);
    from = to;
  }
  return text;
}

}  // namespace

int RangeRule::half_width(int dy) const {
  const int r = static_cast<int>(range), d = std::abs(dy);
  if (d > r) return -1;
  if (shape == RangeShape::moore) return r;
  if (shape == RangeShape::von_neumann) return r - d;
  int width = 0;
  while ((width + 1) * (width + 1) + d * d <= r * r + r) ++width;
  return width;
}

unsigned RangeRule::cells_counted() const {
  int cells = 0;
  for (int dy = -static_cast<int>(range); dy <= static_cast<int>(range); ++dy)
    cells += 2 * half_width(dy) + 1;
  return static_cast<unsigned>(cells) - (middle ? 0u : 1u);
}

RangeRule parse_range_rule(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  RangeRule rule;
  bool has_range = false, has_birth = false, has_survival = false;
  std::vector<std::string_view> birth, survival, *last = nullptr;
  for (const std::string_view part : split(upper, ',')) {
    if (part.empty()) refuse(text, "a part of it is empty");
    const std::string_view rest = part.substr(1);
    std::vector<std::string_view>* list = nullptr;
    switch (part[0]) {
      case 'R':
        rule.range = number(text, rest);
        has_range = true;
        break;
      case 'C':
        if (number(text, rest) != 0 && number(text, rest) != 2) refuse(text, "it has more than two states");
        break;
      case 'M':
        if (rest != "0" && rest != "1") refuse(text, "M is 0 or 1");
        rule.middle = rest == "1";
        break;
      case 'N':
        if (rest != "M" && rest != "N" && rest != "C")
          refuse(text, fmt::format("there is no neighbourhood '{}'", rest));
        rule.shape = rest == "M"   ? RangeShape::moore
                     : rest == "N" ? RangeShape::von_neumann
                                   : RangeShape::circular;
        break;
      case 'S':
        list = &survival;
        has_survival = true;
        break;
      case 'B':
        list = &birth;
        has_birth = true;
        break;
      default:
        // Another count or interval of the set that was begun.
        if (last == nullptr || std::isdigit(static_cast<unsigned char>(part[0])) == 0)
          refuse(text, fmt::format("'{}' says nothing", part));
        last->push_back(part);
        continue;
    }
    last = list;
    if (list != nullptr) list->push_back(rest);
  }
  if (!has_range || !has_birth || !has_survival) refuse(text, "R, S and B must be given");
  if (rule.range < 1 || rule.range > RangeRule::most_range)
    refuse(text, fmt::format("the range is not 1 to {}", RangeRule::most_range));
  rule.birth.assign(rule.cells_counted() + 1, 0);
  rule.survival = rule.birth;
  for (const std::string_view part : birth) include_counts(text, part, rule.birth);
  for (const std::string_view part : survival) include_counts(text, part, rule.survival);
  return rule;
}

std::string range_rule_text(const RangeRule& rule) {
  const char* shape = rule.shape == RangeShape::moore         ? "M"
                      : rule.shape == RangeShape::von_neumann ? "N"
                                                              : "C";
  return fmt::format("R{},C2,M{},S{},B{},N{}", rule.range, rule.middle ? 1 : 0, intervals(rule.survival),
                     intervals(rule.birth), shape);
}

}  // namespace verdigris
