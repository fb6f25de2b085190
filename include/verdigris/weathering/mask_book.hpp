#pragma once
// The masks that a timeline can name: what lies on the surface, what is known of it, and what it has become.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/exposure/mask_catalogue.hpp"
#include "verdigris/weathering/coated_metal.hpp"

namespace verdigris {

/// Masks by name, computed when first asked for: those of a scene, the sources of a MaskCatalogue with their
/// defaults, and of the present state `bare` (no applied coat), `corroded` and `damage`, all 0 or 1.
class MaskBook {
 public:
  /// `up` is an axis or three numbers, and goes to the parameters up, towards and from of the sources. The
  /// surface must outlive it. A scene's mask hides a source of its name.
  MaskBook(const Surface& surface, std::vector<Mask> own, std::string up, std::uint64_t seed,
           MaskCatalogue sources = builtin_masks());

  /// The value of an expression over masks in every slot, see MaskExpression. Throws InputError naming
  /// `where`.
  Field<float> evaluate(const std::string& expression, const std::string& where, const CoatedMetal& metal);

  /// What masks and operators found of the surface so far.
  ExposureCache& exposures() { return exposures_; }

 private:
  const Field<float>& source(const std::string& name);

  ExposureCache exposures_;
  std::vector<Mask> own_;
  std::string up_;
  std::uint64_t seed_;
  MaskCatalogue sources_;
  std::map<std::string, Field<float>> made_;
};

/// The names that a MaskBook knows, given those of the scene's masks.
std::vector<std::string> mask_book_names(const std::vector<std::string>& own,
                                         const MaskCatalogue& sources = builtin_masks());

}  // namespace verdigris
