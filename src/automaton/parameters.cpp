#include "verdigris/automaton/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verdigris/mesh/error.hpp"

namespace verdigris {

void check_parameters(std::string_view behaviour, const std::vector<ParameterInfo>& known,
                      const ParameterValues& values) {
  for (const auto& given : values) {
    const std::string& name = given.first;
    const double value = given.second;
    const auto info =
        std::find_if(known.begin(), known.end(), [&](const ParameterInfo& p) { return p.name == name; });
    const std::string where = fmt::format("{}.{}", behaviour, name);
    if (info == known.end()) {
      std::string names;
      for (const ParameterInfo& p : known) {
        if (!names.empty()) names += ", ";
        names += p.name;
      }
      throw InputError(where, "no such parameter", "the parameters are: " + names);
    }
    if (!(value >= info->least && value <= info->greatest))
      throw InputError(
          where, fmt::format("{} is out of range", value),
          fmt::format("give a value from {} to {} ({})", info->least, info->greatest, info->help));
    if (info->integer && value != std::floor(value))
      throw InputError(where, fmt::format("{} is not a whole number", value),
                       fmt::format("give a whole number from {} to {}", info->least, info->greatest));
  }
}

}  // namespace verdigris
