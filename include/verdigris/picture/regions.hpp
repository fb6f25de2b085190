#pragma once
// Labelled regions on a surface as colours of its cells.

#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/picture/palette.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// The pairs of labels that meet in neighbouring cells (ghosts included), sorted. `labels` [slot], -1 for
/// none.
std::vector<LabelPair> touching_labels(const Surface& surface, std::span<const std::int32_t> labels);

/// A colour for each label 0..largest: assign_colours over touching_labels. For an animation take the labels
/// of the last frame, or all frames differ. Labels should be dense: memory grows with the largest.
std::vector<Rgba8> label_colours(const Surface& surface, std::span<const std::int32_t> labels);

/// How regions are drawn.
struct LabelStyle {
  bool outlines = true;  ///< darken the cells of the lower label where two regions meet: lines one cell wide
  float outline_shade = 0.5f;  ///< factor on their colour, linear light
};

/// Slot colours, ghosts included, from slot labels and a colour for each label; `unlabelled` for -1.
std::vector<Rgba8> colour_labels(const Surface& surface, std::span<const std::int32_t> labels,
                                 std::span<const Rgba8> colour_of_label, const LabelStyle& style = {});

}  // namespace verdigris
