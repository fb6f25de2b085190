#include "verdigris/base/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

template <typename Names>
std::string joined(const Names& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

// "voronoi.corner"; an option stands for itself.
std::string place_of(std::string_view owner, const std::string& name) {
  return owner.starts_with("--") ? std::string(owner) : fmt::format("{}.{}", owner, name);
}

void check_number(const std::string& where, const ParameterInfo& info, double value) {
  if (!(value >= info.least && value <= info.greatest))
    throw InputError(
        where, fmt::format("{} is out of range", value),
        fmt::format("give a value from {:g} to {:g} ({})", info.least, info.greatest, info.help));
  if (info.integer && value != std::floor(value))
    throw InputError(where, fmt::format("{} is not a whole number", value),
                     fmt::format("give a whole number from {:g} to {:g}", info.least, info.greatest));
}

void check_text(const std::string& where, const ParameterInfo& info, const std::string& value) {
  if (!info.choices.empty() &&
      std::find(info.choices.begin(), info.choices.end(), value) == info.choices.end())
    throw InputError(where, fmt::format("there is no '{}'", value), "choose one of: " + joined(info.choices));
}

}  // namespace

std::string parameter_text(const ParameterValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return fmt::format("{}", std::get<double>(value));
}

ParameterValue parse_parameter(std::string_view owner, const ParameterInfo& info, std::string_view text) {
  if (info.is_text()) {
    check_parameters(owner, {info}, {{info.name, std::string(text)}});
    return std::string(text);
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError(place_of(owner, info.name), fmt::format("'{}' is not a number", text),
                     fmt::format("give a number from {:g} to {:g}", info.least, info.greatest));
  check_parameters(owner, {info}, {{info.name, value}});
  return value;
}

void check_parameters(std::string_view owner, const std::vector<ParameterInfo>& known,
                      const ParameterValues& values) {
  for (const auto& given : values) {
    const std::string& name = given.first;
    const auto info =
        std::find_if(known.begin(), known.end(), [&](const ParameterInfo& p) { return p.name == name; });
    const std::string where = place_of(owner, name);
    if (info == known.end()) {
      std::vector<std::string> names;
      for (const ParameterInfo& p : known) names.push_back(p.name);
      throw InputError(where, "no such parameter",
                       names.empty() ? "it has none" : "the parameters are: " + joined(names));
    }
    if (info->is_text() != std::holds_alternative<std::string>(given.second))
      throw InputError(
          where,
          fmt::format("'{}' is not a {}", parameter_text(given.second), info->is_text() ? "text" : "number"),
          info->is_text() ? "put it in quotes"
                          : fmt::format("give a number from {:g} to {:g}", info->least, info->greatest));
    if (info->is_text())
      check_text(where, *info, std::get<std::string>(given.second));
    else
      check_number(where, *info, std::get<double>(given.second));
  }
}

}  // namespace verdigris
