#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "options.hpp"
#include "verdigris/behaviours/builtin.hpp"

namespace {

void print_text(const verdigris::Catalogue& catalogue) {
  for (const auto& entry : catalogue.entries()) {
    fmt::print("{}\n  {}{}\n", entry.name, entry.summary, entry.needs_seeds ? "; takes seeds" : "");
    for (const auto& p : entry.parameters)
      fmt::print("  {:<12} {:g}  [{:g} .. {:g}]{}\n  {:<12} {}\n", p.name, p.default_value, p.least,
                 p.greatest, p.unit == "1" ? "" : " " + p.unit, "", p.help);
  }
}

void print_json(const verdigris::Catalogue& catalogue) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& entry : catalogue.entries()) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (const auto& p : entry.parameters)
      parameters.push_back({{"name", p.name},
                            {"default", p.default_value},
                            {"least", p.least},
                            {"greatest", p.greatest},
                            {"integer", p.integer},
                            {"unit", p.unit},
                            {"help", p.help}});
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
