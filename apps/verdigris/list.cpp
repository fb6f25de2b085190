#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "options.hpp"
#include "verdigris/behaviours/builtin.hpp"
#include "verdigris/synthesis/builtin.hpp"
#include "verdigris/weathering/operators.hpp"

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

nlohmann::ordered_json described(const std::vector<verdigris::ParameterInfo>& parameters) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& p : parameters) list.push_back(described(p));
  return list;
}

void print_entry(const std::string& name, const std::string& summary,
                 const std::vector<verdigris::ParameterInfo>& parameters) {
  fmt::print("{}\n  {}\n", name, summary);
  for (const auto& p : parameters)
    fmt::print("  {:<12} {}  [{}]{}\n  {:<12} {}\n", p.name, verdigris::parameter_text(p.default_value),
               allowed(p), p.unit == "1" ? "" : " " + p.unit, "", p.help);
}

void print_text(const verdigris::Catalogue& catalogue) {
  fmt::print("behaviours\n\n");
  for (const auto& entry : catalogue.entries())
    print_entry(
        entry.name,
        entry.summary + (entry.needs_seeds ? "; takes seeds" : "") +
            (entry.masks.empty() ? "" : fmt::format("; takes masks: {}", fmt::join(entry.masks, ", "))),
        entry.parameters);
  fmt::print("\noperators of timelines\n\n");
  const verdigris::OperatorCatalogue operators = verdigris::builtin_operators();
  for (const auto& entry : operators.entries())
    print_entry(entry.name, fmt::format("{}; takes masks: {}", entry.summary, fmt::join(entry.masks, ", ")),
                entry.parameters);
  fmt::print("\nprimitives\n\n");
  print_primitives();
}

void print_json(const verdigris::Catalogue& catalogue) {
  nlohmann::ordered_json behaviours = nlohmann::ordered_json::array(),
                         operators = nlohmann::ordered_json::array(),
                         primitives = nlohmann::ordered_json::array();
  const verdigris::OperatorCatalogue weathering = verdigris::builtin_operators();
  for (const auto& entry : weathering.entries())
    operators.push_back({{"name", entry.name},
                         {"summary", entry.summary},
                         {"masks", entry.masks},
                         {"parameters", described(entry.parameters)}});
  for (const auto& entry : catalogue.entries())
    behaviours.push_back({{"name", entry.name},
                          {"summary", entry.summary},
                          {"needs_seeds", entry.needs_seeds},
                          {"masks", entry.masks},
                          {"parameters", described(entry.parameters)}});
  const verdigris::PrimitiveCatalogue synthesis = verdigris::builtin_primitives();
  for (const auto& entry : synthesis.entries())
    primitives.push_back({{"name", entry.name},
                          {"summary", entry.summary},
                          {"dimension", entry.dimension},
                          {"parameters", described(entry.parameters)}});
  fmt::print(
      "{}\n",
      nlohmann::ordered_json{{"behaviours", behaviours}, {"operators", operators}, {"primitives", primitives}}
          .dump(2));
}

}  // namespace

void print_primitives() {
  const verdigris::PrimitiveCatalogue catalogue = verdigris::builtin_primitives();
  for (const auto& entry : catalogue.entries()) print_entry(entry.name, entry.summary, entry.parameters);
}

void add_list(CLI::App& app) {
  auto* command = app.add_subcommand(
      "list", "Behaviours, operators, primitives and their parameters, with ranges and defaults");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "As one JSON object on standard output");
  command->callback([json] {
    *json ? print_json(verdigris::builtin_catalogue()) : print_text(verdigris::builtin_catalogue());
  });
}
