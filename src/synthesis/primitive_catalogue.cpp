#include "verdigris/synthesis/primitive_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "verdigris/base/error.hpp"

namespace verdigris {

void PrimitiveCatalogue::add(PrimitiveEntry entry) {
  if (std::any_of(entries_.begin(), entries_.end(),
                  [&](const PrimitiveEntry& e) { return e.name == entry.name; }))
    throw std::invalid_argument("the catalogue already has a primitive named " + entry.name);
  entries_.push_back(std::move(entry));
}

const PrimitiveEntry& PrimitiveCatalogue::find(std::string_view name) const {
  std::string names;
  for (const PrimitiveEntry& entry : entries_) {
    if (entry.name == name) return entry;
    if (!names.empty()) names += ", ";
    names += entry.name;
  }
  throw InputError("primitive", fmt::format("there is none named '{}'", name), "choose one of: " + names);
}

}  // namespace verdigris
