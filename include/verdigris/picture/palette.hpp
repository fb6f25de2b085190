#pragma once
// Colours for labels and for scalars.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "verdigris/picture/colour.hpp"

namespace verdigris {

/// The palette for regions: copper, verdigris and what goes with them. Every two differ by at least 8
/// (colour_difference), lightness stays within a narrow band, so that light and shade remain readable.
std::span<const Rgba8> region_palette();

/// For cells without a label: darker than any region.
inline constexpr Rgba8 unlabelled{84, 84, 88, 255};

/// Two regions that touch, smaller label first.
using LabelPair = std::pair<std::int32_t, std::int32_t>;

/// A colour for each of the labels 0..count-1 so that regions that touch differ clearly and all colours of
/// the palette are used about equally often. Greedy, most neighbours first; depends on nothing but the
/// arguments. `touching` is sorted and has no repetitions. Labels with more neighbours than the palette has
/// colours get the least bad one.
std::vector<Rgba8> assign_colours(std::int32_t count, std::span<const LabelPair> touching,
                                  std::span<const Rgba8> palette = region_palette());

/// A perceptually uniform colour map from deep verdigris through copper to pale gold, for scalars: 0..1,
/// clamped; lightness rises evenly, so it reads in grey too. Not a number gives `unlabelled`.
Rgba8 scalar_colour(float value);

}  // namespace verdigris
