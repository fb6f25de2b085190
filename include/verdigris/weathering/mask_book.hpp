#pragma once
// The masks that a timeline can name: what lies on the surface, what is known of it, and what it has become.

#include <string>
#include <string_view>
#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/exposure/source_masks.hpp"
#include "verdigris/weathering/coated_metal.hpp"

namespace verdigris {

/// Masks by name: those of a scene, the sources of a catalogue with their defaults, made when first asked
/// for, and of the present state `bare` (no applied coat), `corroded` and `damage`, all 0 or 1.
class MaskBook {
 public:
  /// `sources` must outlive it. A scene's mask hides a source of its name.
  MaskBook(SourceMasks& sources, std::vector<Mask> own);

  /// The value of an expression over masks in every slot, see MaskExpression. Throws InputError naming
  /// `where`.
  Field<float> evaluate(const std::string& expression, const std::string& where, const CoatedMetal& metal);

  SourceMasks& sources() const { return sources_; }

 private:
  SourceMasks& sources_;
  std::vector<Mask> own_;
};

/// The names that a MaskBook knows, given those of the scene's masks.
std::vector<std::string> mask_book_names(const std::vector<std::string>& own,
                                         const MaskCatalogue& sources = builtin_masks());

}  // namespace verdigris
