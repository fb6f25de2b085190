#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "options.hpp"
#include "verdigris/behaviours/builtin.hpp"

namespace {

// What a parameter may be: a range, choices, or any text.
std::string allowed(const verdigris::ParameterInfo& p) {
  if (!p.is_text()) return fmt::format("{:g} .. {:g}", p.least, p.greatest);
  return p.choices.empty() ? "text" : fmt::format("{}", fmt::join(p.choices, ", "));
}

nlohmann::ordered_json described(const verdigris::ParameterInfo& p) {
  nlohmann::ordered_json json{{"name", p.name}};
  if (p.is_text())
    json.update({{"default", std::get<std::string>(p.default_value)}, {"choices", p.choices}});
  else
    json.update({{"default", std::get<double>(p.default_value)},
                 {"least", p.least},
                 {"greatest", p.greatest},
                 {"integer", p.integer},
                 {"unit", p.unit}});
  json["help"] = p.help;
  return json;
}

void print_text(const verdigris::Catalogue& catalogue) {
  for (const auto& entry : catalogue.entries()) {
    fmt::print("{}\n  {}{}\n", entry.name, entry.summary, entry.needs_seeds ? "; takes seeds" : "");
    for (const auto& p : entry.parameters)
      fmt::print("  {:<12} {}  [{}]{}\n  {:<12} {}\n", p.name, verdigris::parameter_text(p.default_value),
                 allowed(p), p.unit == "1" ? "" : " " + p.unit, "", p.help);
  }
}

void print_json(const verdigris::Catalogue& catalogue) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& entry : catalogue.entries()) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (const auto& p : entry.parameters) parameters.push_back(described(p));
    list.push_back({{"name", entry.name},
                    {"summary", entry.summary},
                    {"needs_seeds", entry.needs_seeds},
                    {"parameters", parameters}});
  }
  fmt::print("{}\n", nlohmann::ordered_json{{"behaviours", list}}.dump(2));
}

}  // namespace

void add_list(CLI::App& app) {
  auto* command = app.add_subcommand("list", "Behaviours and their parameters, with ranges and defaults");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "As one JSON object on standard output");
  command->callback([json] {
    *json ? print_json(verdigris::builtin_catalogue()) : print_text(verdigris::builtin_catalogue());
  });
}
