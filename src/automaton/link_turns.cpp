#include "verdigris/automaton/link_turns.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "verdigris/surface/walk.hpp"

namespace verdigris {

namespace {

unsigned eighths(double c, double s) {
  const long turns = std::lround(std::atan2(s, c) * 4.0 / std::numbers::pi);
  return static_cast<unsigned>(turns + 8) % 8;
}

// The rotation about m x n that brings unit normal m onto n, applied to d.
glm::dvec3 brought_over(const glm::dvec3& m, const glm::dvec3& n, const glm::dvec3& d) {
  const glm::dvec3 axis = glm::cross(m, n);
  const double c = glm::dot(m, n);
  if (c < -0.999999) return d;  // back to back: any axis would do
  return d * c + glm::cross(axis, d) + axis * (glm::dot(axis, d) / (1.0 + c));
}

}  // namespace

unsigned frame_turn(const Surface& surface, std::uint32_t from, std::uint32_t to) {
  if (from == to) return 0;
  const Unfolding unfolding(surface.frames(), surface.adjacency(), surface.barred_edges());
  const Frame &a = surface.frame(from), &b = surface.frame(to);
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t across = unfolding.across(from, k);
    if (across == Adjacency::none || across / 3 != to) continue;
    const Motion motion = unfold(a, k, b, unfolding.frame_edge(across));
    return eighths(motion.c, motion.s);
  }
  const glm::dvec3 u = brought_over(a.normal(), b.normal(), a.u);
  return eighths(glm::dot(u, b.u), glm::dot(u, b.v));
}

std::vector<std::uint8_t> link_turns(const Surface& surface) {
  const Links& links = surface.links();
  std::vector<std::uint8_t> turns(links.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, links.word_count(), 1024),
      [&](const tbb::blocked_range<std::size_t>& range) {
        // Links come edge by edge: the last pair of patches is nearly always the next one.
        std::uint32_t from = 0, to = 0, last_row = 0xFFFFFFFFu, source_patch = 0;
        unsigned turn = 0;
        links.for_each_between(range.begin(), range.end(), [&](std::uint32_t source, auto ghosts) {
          const std::uint32_t row = surface.row_of(source);
          if (row != last_row) source_patch = surface.patch_of_row(row);
          last_row = row;
          const auto first = static_cast<std::size_t>(ghosts.data() - links.all_targets().data());
          for (std::size_t k = 0; k < ghosts.size(); ++k) {
            const std::uint32_t patch = surface.patch_of_row(surface.row_of(ghosts[k]));
            if (patch != to || source_patch != from) turn = frame_turn(surface, source_patch, patch);
            from = source_patch;
            to = patch;
            turns[first + k] = static_cast<std::uint8_t>(turn);
          }
        });
      });
  return turns;
}

}  // namespace verdigris
