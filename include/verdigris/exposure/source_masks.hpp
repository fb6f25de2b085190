#pragma once
// The masks that the sources of a catalogue give on one surface, each found once.

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <string>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/exposure/exposure_cache.hpp"
#include "verdigris/exposure/mask_catalogue.hpp"

namespace verdigris {

/// For one run: it goes from hand to hand. For one thread at a time.
class SourceMasks {
 public:
  /// `up` is an axis or three numbers, and goes to the parameters up, towards and from of the sources. The
  /// surface must outlive it. Throws InputError for an `up` that is no direction.
  SourceMasks(const Surface& surface, std::string up, std::uint64_t seed,
              MaskCatalogue catalogue = builtin_masks());

  const Surface& surface() const { return exposures_.surface(); }
  const MaskCatalogue& catalogue() const { return catalogue_; }
  ExposureCache& exposures() { return exposures_; }
  /// Away from the ground, unit.
  glm::dvec3 up() const { return up_direction_; }

  /// A source with its defaults and the seed of the run, made when first asked for; stays where it is.
  /// Throws InputError.
  const Field<float>& named(const std::string& source);
  /// A source with parameters of its own.
  Field<float> make(const MaskEntry& source, const ParameterValues& given, std::uint64_t seed);

 private:
  ExposureCache exposures_;
  MaskCatalogue catalogue_;
  std::string up_;
  glm::dvec3 up_direction_;
  std::uint64_t seed_;
  std::map<std::string, Field<float>> made_;
};

}  // namespace verdigris
