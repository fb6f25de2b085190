#pragma once
// Parameters that describe themselves: one declaration beside the value gives help, ranges, options and scene
// keys.

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace verdigris {

/// A number or a text.
using ParameterValue = std::variant<double, std::string>;

/// One parameter, as shown to users. Numbers have a range, texts may have a list of choices.
struct ParameterInfo {
  std::string name;
  ParameterValue default_value;
  double least = 0.0, greatest = 0.0;  ///< numbers: allowed range, both included
  bool integer = false;                ///< numbers: whole ones only
  std::string unit = "1";              ///< "1" for a pure number
  std::string help;
  std::vector<std::string> choices;  ///< texts: what it may be; empty: whatever its owner understands

  bool is_text() const { return std::holds_alternative<std::string>(default_value); }
};

/// Values given by name; what is not named keeps its default.
using ParameterValues = std::vector<std::pair<std::string, ParameterValue>>;

/// The value as a user would write it; numbers in the fewest digits that bring them back.
std::string parameter_text(const ParameterValue& value);

/// What a user wrote for `info`, as its kind of value. Throws InputError as check_parameters does.
ParameterValue parse_parameter(std::string_view owner, const ParameterInfo& info, std::string_view text);

/// Throws InputError when a name is not among `known`, or a value is of the wrong kind, outside its range,
/// not whole where it must be, or not among the choices. `owner` is named in the message.
void check_parameters(std::string_view owner, const std::vector<ParameterInfo>& known,
                      const ParameterValues& values);

namespace detail {
struct ParameterLister {
  std::vector<ParameterInfo>& list;
  template <typename T>
  void operator()(const char* name, T& value, double least, double greatest, const char* unit,
                  const char* help) const {
    list.push_back(
        {name, static_cast<double>(value), least, greatest, !std::is_floating_point_v<T>, unit, help, {}});
  }
  void operator()(const char* name, std::string& value, std::vector<std::string> choices,
                  const char* help) const {
    list.push_back({name, value, 0.0, 0.0, false, "1", help, std::move(choices)});
  }
};
struct ParameterSetter {
  const ParameterValues& values;
  template <typename T>
  void operator()(const char* name, T& value, double, double, const char*, const char*) const {
    for (const auto& [given, to] : values)
      if (given == name) value = static_cast<T>(std::get<double>(to));
  }
  void operator()(const char* name, std::string& value, const std::vector<std::string>&, const char*) const {
    for (const auto& [given, to] : values)
      if (given == name) value = std::get<std::string>(to);
  }
};
}  // namespace detail

/// A type with `template <typename V> void parameters(V&& v)` that calls v(name, member, least, greatest,
/// unit, help) for each of its numbers and v(name, member, choices, help) for each of its texts.
template <typename T>
std::vector<ParameterInfo> describe_parameters() {
  std::vector<ParameterInfo> list;
  T defaults;
  defaults.parameters(detail::ParameterLister{list});
  return list;
}

/// A T with `values` set. Throws InputError as check_parameters does.
template <typename T>
T with_parameters(std::string_view owner, const ParameterValues& values) {
  check_parameters(owner, describe_parameters<T>(), values);
  T object;
  object.parameters(detail::ParameterSetter{values});
  return object;
}

}  // namespace verdigris
