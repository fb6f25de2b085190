#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/lsystem.hpp"

namespace verdigris {

namespace {

constexpr std::size_t most_parameters = 8;
constexpr std::size_t most_text = std::size_t{1} << 20;
constexpr int most_iterations = 1000;

bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}
bool is_symbol(char c) {
  return c > ' ' && c <= '~' && std::string_view("(),=#").find(c) == std::string_view::npos;
}
bool is_name(std::string_view text) {
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
}

class LSystemParser {
 public:
  LSystemParser(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  LSystem parse() {
    if (text_.size() > most_text)
      throw InputError(where_, fmt::format("{} bytes", text_.size()), "L-systems are at most 1 MB of text");
    for (std::size_t begin = 0; begin <= text_.size(); ++line_number_) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      line_ = text_.substr(begin, end - begin);
      line_ = line_.substr(0, line_.find('#'));
      while (!line_.empty() && blank(line_.back())) line_.remove_suffix(1);
      at_ = 0;
      skip_blanks();
      if (at_ < line_.size()) read_line();
      begin = end + 1;
    }
    if (!has_axiom_) throw InputError(where_, "there is no axiom", "say what words start as: `axiom = F`");
    check_weights();
    return std::move(system_);
  }

 private:
  [[noreturn]] void fault(std::size_t at, std::string problem, std::string remedy) const {
    throw InputError(fmt::format("{}:{}:{}", where_, line_number_, at + 1), std::move(problem),
                     std::move(remedy));
  }
  void skip_blanks() {
    while (at_ < line_.size() && blank(line_[at_])) ++at_;
  }

  void read_line() {
    const std::size_t arrow = line_.find("->", at_ + 1);
    if (arrow != std::string_view::npos) {
      read_rule(arrow);
      return;
    }
    const std::size_t equals = line_.find('=', at_);
    if (equals == std::string_view::npos)
      fault(at_, "neither a rule nor a setting", "write `F -> FF` or `angle = 25`");
    std::string_view key = line_.substr(at_, equals - at_);
    while (!key.empty() && blank(key.back())) key.remove_suffix(1);
    const std::size_t key_at = at_;
    at_ = equals + 1;
    skip_blanks();
    set(key, key_at);
  }

  double number(double least, double greatest, std::string_view what) {
    const std::size_t from = at_;
    const double value = expression(line_.substr(at_), {})({});
    if (!(value >= least && value <= greatest))
      fault(from, fmt::format("{} is no {}", value, what),
            fmt::format("give a number from {:g} to {:g}", least, greatest));
    return value;
  }

  Expression expression(std::string_view text, std::span<const std::string> parameters) const {
    try {
      return parse_expression(text, parameters, constants_);
    } catch (const ExpressionFault& f) {
      fault(static_cast<std::size_t>(text.data() - line_.data()) + f.offset, f.problem, f.remedy);
    }
  }

  void set(std::string_view key, std::size_t key_at) {
    TurtleSettings& turtle = system_.turtle;
    if (key == "axiom") {
      if (has_axiom_) fault(key_at, "a second axiom", "keep one of them");
      has_axiom_ = true;
      read_axiom();
    } else if (key == "angle") {
      turtle.angle = number(-360.0, 360.0, "angle");
    } else if (key == "step") {
      turtle.step = number(1e-9, 1e9, "step");
    } else if (key == "width") {
      turtle.width = number(1e-9, 1e9, "width");
    } else if (key == "taper") {
      turtle.taper = number(1e-3, 1e3, "taper");
    } else if (key == "iterations") {
      const std::size_t from = at_;
      const double value = number(0.0, most_iterations, "number of iterations");
      if (value != std::floor(value)) fault(from, fmt::format("{} iterations", value), "give a whole number");
      system_.iterations = static_cast<int>(value);
    } else if (key == "draw" || key == "move" || key == "back") {
      std::string& symbols = key == "draw" ? turtle.draw : key == "move" ? turtle.move : turtle.back;
      symbols.clear();
      for (; at_ < line_.size(); skip_blanks()) symbols += line_[at_++];
    } else if (key.starts_with("let ") || key.starts_with("let\t")) {
      std::string_view name = key.substr(4);
      while (!name.empty() && blank(name.front())) name.remove_prefix(1);
      if (!is_name(name)) fault(key_at, fmt::format("'{}' is no name", name), "write `let r = 0.7`");
      constants_.emplace_back(name, number(-1e300, 1e300, "number"));
    } else {
      fault(
          key_at, fmt::format("there is no setting '{}'", key),
          "the settings are: angle, iterations, step, width, taper, draw, move, back, axiom and `let name`");
    }
  }

  // What stands between the bracket at `at_` and its partner, cut at the commas.
  std::vector<std::string_view> bracketed() {
    std::vector<std::string_view> parts;
    const std::size_t open = at_++;
    std::size_t begin = at_;
    int deep = 0;
    for (; at_ < line_.size(); ++at_) {
      const char c = line_[at_];
      if (c == '(') ++deep;
      if (deep == 0 && (c == ',' || c == ')')) {
        parts.push_back(line_.substr(begin, at_ - begin));
        begin = at_ + 1;
        if (parts.size() > most_parameters)
          fault(open, "too many values", fmt::format("a symbol has at most {}", most_parameters));
        if (c == ')') {
          ++at_;
          return parts;
        }
      }
      if (c == ')') --deep;
    }
    fault(open, "the bracket is not closed", "write ')' after the last value");
  }

  std::vector<SymbolTemplate> read_word(std::span<const std::string> parameters) {
    std::vector<SymbolTemplate> word;
    std::vector<std::size_t> open;
    for (skip_blanks(); at_ < line_.size(); skip_blanks()) {
      const char c = line_[at_];
      if (!is_symbol(c))
        fault(at_, c > ' ' && c <= '~' ? fmt::format("'{}' is no symbol", c) : "this byte is no symbol",
              "use printable characters but ( ) , = #; a value list follows its symbol: F(2)");
      if (c == '[') open.push_back(at_);
      if (c == ']') {
        if (open.empty()) fault(at_, "']' without a '['", "open every branch in the word that closes it");
        open.pop_back();
      }
      ++at_;
      word.push_back({c, {}});
      if (at_ < line_.size() && line_[at_] == '(')
        for (const std::string_view part : bracketed())
          word.back().arguments.push_back(expression(part, parameters));
    }
    if (!open.empty())
      fault(open.back(), "'[' without a ']'", "close every branch in the word that opens it");
    return word;
  }

  void read_axiom() {
    const std::size_t from = at_;
    const std::vector<SymbolTemplate> word = read_word({});
    if (word.empty()) fault(from, "the axiom is empty", "give it at least one symbol");
    Word& axiom = system_.grammar.axiom;
    for (const SymbolTemplate& symbol : word) {
      axiom.symbols += symbol.symbol;
      for (const Expression& argument : symbol.arguments) {
        axiom.values.push_back(argument({}));
        if (!std::isfinite(axiom.values.back())) fault(from, "a value is not finite", "give finite numbers");
      }
      axiom.ends.push_back(static_cast<std::uint32_t>(axiom.values.size()));
    }
    if (axiom.values.empty()) axiom.ends.clear();
  }

  // The line is cut before the arrow while the left side is read.
  void read_rule(std::size_t arrow) {
    const std::string_view whole = line_;
    line_ = whole.substr(0, arrow);
    Production rule;
    if (!is_symbol(line_[at_]))
      fault(at_, fmt::format("'{}' cannot be replaced", line_[at_]), "begin a rule with a symbol");
    rule.symbol = line_[at_++];
    std::vector<std::string> names;
    if (at_ < line_.size() && line_[at_] == '(')
      for (std::string_view part : bracketed()) {
        while (!part.empty() && blank(part.front())) part.remove_prefix(1);
        while (!part.empty() && blank(part.back())) part.remove_suffix(1);
        if (!is_name(part) || part == "and" || part == "or")
          fault(at_ - 1, fmt::format("'{}' is no name of a parameter", part), "write A(l, w) -> ...");
        names.emplace_back(part);
      }
    rule.parameters = names.size();
    skip_blanks();
    const std::size_t weight_at = std::min(line_.find('@', at_), line_.size());
    if (line_.substr(at_).starts_with("if ")) {
      at_ += 3;
      rule.condition = expression(line_.substr(at_, weight_at - at_), names);
      at_ = weight_at;
    }
    const bool weighted = at_ < line_.size() && line_[at_] == '@';
    if (weighted) {
      ++at_;
      skip_blanks();
      rule.weight = number(1e-9, 1e9, "weight");
    } else if (at_ < line_.size()) {
      fault(at_, "the left side of a rule is one symbol",
            "after it may come its parameters, `if` and a condition, `@` and a weight");
    }
    line_ = whole;
    at_ = arrow + 2;
    rule.successor = read_word(names);
    for (const SymbolTemplate& symbol : rule.successor) rule.values += symbol.arguments.size();
    lines_of_rules_.push_back({line_number_, weighted});
    system_.grammar.productions.push_back(std::move(rule));
  }

  // Two rules for one symbol without condition or weight are more likely a slip than a draw.
  void check_weights() const {
    const auto& rules = system_.grammar.productions;
    for (std::size_t k = 0; k < rules.size(); ++k)
      for (std::size_t j = 0; j < k && !rules[k].condition && !lines_of_rules_[k].second; ++j)
        if (rules[j].symbol == rules[k].symbol && rules[j].parameters == rules[k].parameters &&
            !rules[j].condition && !lines_of_rules_[j].second)
          throw InputError(
              fmt::format("{}:{}:1", where_, lines_of_rules_[k].first),
              fmt::format("{} has a rule already in line {}", rules[k].symbol, lines_of_rules_[j].first),
              fmt::format("give both a weight, `{} @ 0.5 -> ...`, or a condition", rules[k].symbol));
  }

  std::string_view text_;
  const std::string& where_;
  std::string_view line_;
  std::size_t at_ = 0;  // in line_
  int line_number_ = 1;
  LSystem system_;
  bool has_axiom_ = false;
  std::vector<NamedNumber> constants_;
  std::vector<std::pair<int, bool>> lines_of_rules_;  // line, has a weight
};

}  // namespace

LSystem parse_lsystem(std::string_view text, const std::string& where) {
  return LSystemParser(text, where).parse();
}

}  // namespace verdigris
