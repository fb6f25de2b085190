#include "verdigris/picture/regions.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace verdigris {

namespace {

// Slots that evolve: every label a region really has is on one of them, ghosts only repeat.
template <typename Visit>
void for_each_row(const Surface& surface, const Visit& visit) {
  tbb::parallel_for(
      tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(surface.rows().size()), 256),
      [&](const tbb::blocked_range<std::uint32_t>& range) {
        for (std::uint32_t row = range.begin(); row < range.end(); ++row) {
          const Row& r = surface.rows()[row];
          if (r.run_begin < r.run_end) visit(row, r);
        }
      });
}

void sort_unique(std::vector<LabelPair>& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

}  // namespace

std::vector<LabelPair> touching_labels(const Surface& surface, std::span<const std::int32_t> labels) {
  constexpr std::size_t compact_at = 1u << 16;
  struct Found {
    std::vector<LabelPair> pairs;
    std::size_t limit = compact_at;
  };
  tbb::enumerable_thread_specific<Found> found;
  for_each_row(surface, [&](std::uint32_t row, const Row& r) {
    Found& mine = found.local();
    const Row& above = surface.rows()[row + 1];
    const Row& below = surface.rows()[row - 1];
    for (std::uint32_t slot = r.run_begin; slot < r.run_end; ++slot) {
      const std::int32_t label = labels[slot];
      if (label < 0) continue;
      const std::uint32_t up = slot - r.base + above.base, down = slot - r.base + below.base;
      // Ghosts lie on all sides, so all eight are looked at; nearly always they are equal.
      for (const std::uint32_t other : {slot - 1, slot + 1, up - 1, up, up + 1, down - 1, down, down + 1}) {
        const std::int32_t beyond = labels[other];
        if (beyond < 0 || beyond == label) continue;
        const LabelPair pair = std::minmax(label, beyond);
        if (mine.pairs.empty() || mine.pairs.back() != pair) mine.pairs.push_back(pair);
      }
    }
    if (mine.pairs.size() > mine.limit) {
      sort_unique(mine.pairs);
      mine.limit = std::max(compact_at, 2 * mine.pairs.size());
    }
  });
  std::vector<LabelPair> all;
  for (const Found& part : found) all.insert(all.end(), part.pairs.begin(), part.pairs.end());
  sort_unique(all);
  return all;
}

std::vector<Rgba8> label_colours(const Surface& surface, std::span<const std::int32_t> labels) {
  const std::int32_t largest = labels.empty() ? -1 : *std::max_element(labels.begin(), labels.end());
  return assign_colours(largest + 1, touching_labels(surface, labels));
}

std::vector<Rgba8> colour_labels(const Surface& surface, std::span<const std::int32_t> labels,
                                 std::span<const Rgba8> colour_of_label, const LabelStyle& style) {
  std::vector<Rgba8> shaded(colour_of_label.size());
  for (std::size_t k = 0; k < shaded.size(); ++k)
    shaded[k] = from_linear(style.outline_shade * to_linear(colour_of_label[k]), colour_of_label[k].a);
  std::vector<Rgba8> colours(surface.slot_count(), unlabelled);
  for_each_row(surface, [&](std::uint32_t row, const Row& r) {
    const Row& above = surface.rows()[row + 1];
    const Row& below = surface.rows()[row - 1];
    for (std::uint32_t slot = r.run_begin; slot < r.run_end; ++slot) {
      const std::int32_t label = labels[slot];
      if (label < 0) continue;
      const std::uint32_t up = slot - r.base + above.base, down = slot - r.base + below.base;
      // Sides only: with corners the line would be thicker on diagonals than along the rows.
      const bool edge = style.outlines && (labels[slot - 1] > label || labels[slot + 1] > label ||
                                           labels[up] > label || labels[down] > label);
      colours[slot] = (edge ? shaded : colour_of_label)[static_cast<std::size_t>(label)];
    }
  });
  // With projected links too, unlike copy_to_ghosts: a pair is of one region.
  surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) colours[target] = colours[source];
  });
  return colours;
}

}  // namespace verdigris
