#include "verdigris/automaton/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "verdigris/base/error.hpp"

namespace verdigris {

const Field<float>* SimulationSetup::mask(std::string_view name) const {
  const auto found = std::find_if(masks.begin(), masks.end(), [&](const Mask& m) { return m.name == name; });
  return found == masks.end() ? nullptr : &found->values;
}

void Catalogue::add(BehaviourEntry entry) {
  if (std::any_of(entries_.begin(), entries_.end(),
                  [&](const BehaviourEntry& e) { return e.name == entry.name; }))
    throw std::invalid_argument("the catalogue already has a behaviour named " + entry.name);
  entries_.push_back(std::move(entry));
}

const BehaviourEntry& Catalogue::find(std::string_view name) const {
  std::string names;
  for (const BehaviourEntry& entry : entries_) {
    if (entry.name == name) return entry;
    if (!names.empty()) names += ", ";
    names += entry.name;
  }
  throw InputError("behaviour", fmt::format("there is none named '{}'", name), "choose one of: " + names);
}

}  // namespace verdigris
