#pragma once
// Parameters that describe themselves: one declaration beside the value gives help, ranges, options and scene
// keys.

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace verdigris {

/// One parameter of a behaviour, as shown to users.
struct ParameterInfo {
  std::string name;
  double default_value;
  double least, greatest;  ///< allowed range, both included
  bool integer;            ///< whole numbers only
  std::string unit;        ///< "1" for a pure number
  std::string help;
};

/// Values given by name; what is not named keeps its default.
using ParameterValues = std::vector<std::pair<std::string, double>>;

/// Throws InputError when a name is not among `known`, or a value is outside its range or not whole where it
/// must be.
void check_parameters(std::string_view behaviour, const std::vector<ParameterInfo>& known,
                      const ParameterValues& values);

namespace detail {
struct ParameterLister {
  std::vector<ParameterInfo>& list;
  template <typename T>
  void operator()(const char* name, T& value, double least, double greatest, const char* unit,
                  const char* help) const {
    list.push_back(
        {name, static_cast<double>(value), least, greatest, !std::is_floating_point_v<T>, unit, help});
  }
};
struct ParameterSetter {
  const ParameterValues& values;
  template <typename T>
  void operator()(const char* name, T& value, double, double, const char*, const char*) const {
    for (const auto& [given, to] : values)
      if (given == name) value = static_cast<T>(to);
  }
};
}  // namespace detail

/// A type with `template <typename V> void parameters(V&& v)` that calls v(name, member, least, greatest,
/// unit, help) for each of its parameters.
template <typename T>
std::vector<ParameterInfo> describe_parameters() {
  std::vector<ParameterInfo> list;
  T defaults;
  defaults.parameters(detail::ParameterLister{list});
  return list;
}

/// A T with `values` set. Throws InputError as check_parameters does.
template <typename T>
T with_parameters(std::string_view behaviour, const ParameterValues& values) {
  check_parameters(behaviour, describe_parameters<T>(), values);
  T object;
  object.parameters(detail::ParameterSetter{values});
  return object;
}

}  // namespace verdigris
