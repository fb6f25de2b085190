#include "verdigris/exposure/source_masks.hpp"

#include <utility>

#include "verdigris/exposure/lie.hpp"

namespace verdigris {

SourceMasks::SourceMasks(const Surface& surface, std::string up, std::uint64_t seed, MaskCatalogue catalogue)
    : exposures_(surface),
      catalogue_(std::move(catalogue)),
      up_(std::move(up)),
      up_direction_(parse_direction(up_, "up")),
      seed_(seed) {}

const Field<float>& SourceMasks::named(const std::string& source) {
  if (const auto found = made_.find(source); found != made_.end()) return found->second;
  return made_.emplace(source, make(catalogue_.find(source), {}, seed_)).first->second;
}

Field<float> SourceMasks::make(const MaskEntry& source, const ParameterValues& given, std::uint64_t seed) {
  return source.create(exposures_, with_up(source, given, up_), seed);
}

}  // namespace verdigris
