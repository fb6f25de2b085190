#include "verdigris/weathering/operators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "entries.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

const Field<float>* OperatorSetup::mask(std::string_view name) const {
  for (const Mask& mask : masks)
    if (mask.name == name) return &mask.values;
  return nullptr;
}

double OperatorSetup::at(const Field<float>* mask, std::uint32_t slot) {
  if (mask == nullptr) return 1.0;
  const float value = (*mask)[slot];
  return value >= 0.0f ? std::min(1.0, static_cast<double>(value)) : 0.0;
}

void OperatorCatalogue::add(OperatorEntry entry) {
  for (const OperatorEntry& other : entries_)
    if (other.name == entry.name) throw std::invalid_argument("an operator of that name is there");
  // A scene could not tell them apart.
  for (const ParameterInfo& parameter : entry.parameters)
    if (std::find(entry.masks.begin(), entry.masks.end(), parameter.name) != entry.masks.end())
      throw std::invalid_argument("a mask and a parameter have one name");
  entries_.push_back(std::move(entry));
}

const OperatorEntry& OperatorCatalogue::find(std::string_view name) const {
  std::vector<std::string_view> names;
  for (const OperatorEntry& entry : entries_) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  throw InputError("timeline", fmt::format("there is no operator '{}'", name),
                   fmt::format("choose one of {}", fmt::join(names, ", ")));
}

OperatorCatalogue builtin_operators() {
  OperatorCatalogue catalogue;
  weathering::add_coat(catalogue);
  weathering::add_wear(catalogue);
  weathering::add_scratch(catalogue);
  weathering::add_crack(catalogue);
  weathering::add_peel(catalogue);
  weathering::add_dust(catalogue);
  weathering::add_stain(catalogue);
  weathering::add_age(catalogue);
  return catalogue;
}

}  // namespace verdigris
