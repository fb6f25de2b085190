#pragma once
// The open catalogue of masks: what they come from by name, each with parameters that describe themselves.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/base/parameters.hpp"
#include "verdigris/exposure/exposure_cache.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// One source of masks.
struct MaskEntry {
  std::string name;     ///< letters, digits and _, so that expressions can name masks after it
  std::string summary;  ///< one line
  std::string unit;     ///< of its values: "1" lies in 0..1 but for slope (0..2), others are free
  std::vector<ParameterInfo> parameters;
  /// [slot], ghosts included. Throws InputError for parameters it does not have or cannot use, and for a
  /// surface without what it needs.
  std::function<Field<float>(ExposureCache&, const ParameterValues&, std::uint64_t seed)> create;
};

/// Mask sources by name. A value: whoever makes one may add to it, from outside the library too.
class MaskCatalogue {
 public:
  /// Throws std::invalid_argument when the name is taken.
  void add(MaskEntry entry);

  /// Throws InputError naming the sources there are.
  const MaskEntry& find(std::string_view name) const;
  const std::vector<MaskEntry>& entries() const { return entries_; }

 private:
  std::vector<MaskEntry> entries_;
};

/// The entry of a self-describing source: a struct M with `static constexpr const char *name, *summary,
/// *unit`, `template <typename V> void parameters(V&&)` (see describe_parameters) and `Field<float>
/// make(const Surface&, std::uint64_t seed) const` or `make(ExposureCache&, std::uint64_t seed) const`.
template <typename M>
MaskEntry mask_entry() {
  return {M::name, M::summary, M::unit, describe_parameters<M>(),
          [](ExposureCache& exposures, const ParameterValues& values, std::uint64_t seed) {
            const M mask = with_parameters<M>(M::name, values);
            if constexpr (requires { mask.make(exposures, seed); })
              return mask.make(exposures, seed);
            else
              return mask.make(exposures.surface(), seed);
          }};
}

/// A catalogue of all sources of the library: ao, sky, rain, height, slope, facing, curvature, convex,
/// cavity, lines, colour, wetness, flow, stored, stain.
MaskCatalogue builtin_masks();

/// The names that formulas may use: `own`, then the sources that none of them hides.
std::vector<std::string> formula_names(std::vector<std::string> own,
                                       const MaskCatalogue& sources = builtin_masks());

/// `given` and, for each parameter of the source that says which way is up and was not given, `up`: an axis
/// or three numbers.
ParameterValues with_up(const MaskEntry& entry, ParameterValues given, const std::string& up);

/// A mask of the library's own sources by name.
Field<float> make_mask(const Surface& surface, std::string_view name, const ParameterValues& values = {},
                       std::uint64_t seed = 1);

}  // namespace verdigris
