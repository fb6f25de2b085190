#include "verdigris/exposure/mask_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "mask_entries.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

void MaskCatalogue::add(MaskEntry entry) {
  if (std::any_of(entries_.begin(), entries_.end(), [&](const MaskEntry& e) { return e.name == entry.name; }))
    throw std::invalid_argument("the catalogue already has a mask named " + entry.name);
  entries_.push_back(std::move(entry));
}

const MaskEntry& MaskCatalogue::find(std::string_view name) const {
  std::string names;
  for (const MaskEntry& entry : entries_) {
    if (entry.name == name) return entry;
    if (!names.empty()) names += ", ";
    names += entry.name;
  }
  throw InputError("mask", fmt::format("there is no source named '{}'", name), "choose one of: " + names);
}

MaskCatalogue builtin_masks() {
  MaskCatalogue catalogue;
  add_openness(catalogue);
  add_shape(catalogue);
  add_water(catalogue);
  return catalogue;
}

std::vector<std::string> formula_names(std::vector<std::string> own, const MaskCatalogue& sources) {
  for (const MaskEntry& entry : sources.entries())
    if (std::find(own.begin(), own.end(), entry.name) == own.end()) own.push_back(entry.name);
  return own;
}

ParameterValues with_up(const MaskEntry& entry, ParameterValues given, const std::string& up) {
  for (const ParameterInfo& p : entry.parameters) {
    const bool upward = (p.name == "up" || p.name == "towards" || p.name == "from") &&
                        p.default_value == ParameterValue(std::string("y"));
    const bool is_given =
        std::any_of(given.begin(), given.end(), [&](const auto& pair) { return pair.first == p.name; });
    if (upward && !is_given) given.emplace_back(p.name, up);
  }
  return given;
}

Field<float> make_mask(const Surface& surface, std::string_view name, const ParameterValues& values,
                       std::uint64_t seed) {
  ExposureCache exposures(surface);
  return builtin_masks().find(name).create(exposures, values, seed);
}

}  // namespace verdigris
