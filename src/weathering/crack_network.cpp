#include "verdigris/weathering/crack_network.hpp"

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <utility>

#include "cells.hpp"
#include "distance.hpp"
#include "line_walk.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

using weathering::around;
using weathering::LineWalk;

namespace {

constexpr std::uint32_t none = weathering::no_owner;
constexpr std::uint32_t flaw_purpose = 0x43524b01, angle_purpose = 0x43524b02, wander_purpose = 0x43524b03;
// A crack opens at this distance from others, in units of the spacing. On sheets of 400 cells, spacings of 20
// to 50 cells, the square root of the mean fragment is then 0.95 to 1.06 of the spacing.
constexpr double opening = 0.52;

class Network {
 public:
  Network(const Surface& surface, const CrackSettings& settings, const Field<float>& strain)
      : surface_(surface),
        settings_(settings),
        strain_(strain),
        unfolding_(surface.frames(), surface.adjacency(), surface.barred_edges()),
        spacing_(settings.spacing / surface.cell_size()),
        reach_(static_cast<float>(spacing_)),
        owner_(weathering::owners_of(surface)),
        crack_(surface.slot_count(), 0),
        when_(surface.slot_count(), 0),
        degree_(surface.slot_count(), 0) {
    result.distance.assign(surface.slot_count(), reach_);
  }

  void grow() {
    // Flaws, the worst first.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> flaws;
    flaws.reserve(surface_.owned_count());
    each_owned(surface_, [&](std::uint32_t slot) {
      flaws.emplace_back(CellRandom(settings_.seed, 0, slot).words(flaw_purpose)[0], slot);
    });
    tbb::parallel_sort(flaws);
    for (const auto& [order, slot] : flaws) {
      const double strain = strain_at(slot);
      if (strain > 0.0 && static_cast<double>(result.distance[slot]) * strain >= opening * spacing_)
        open(slot);
    }
    for (const std::uint32_t slot : joints_) ++result.junctions[std::min<std::size_t>(degree_[slot], 3) - 1];
  }

  CrackNetwork result;

 private:
  double strain_at(std::uint32_t slot) const {
    return strain_.empty() ? 1.0 : std::clamp(static_cast<double>(strain_[slot]), 0.0, 1.0);
  }

  // Gradient of the distance in model space: away from the nearest crack.
  glm::dvec3 away(std::uint32_t slot) const {
    const auto n = around(surface_, slot);
    const auto at = [&](std::size_t k) {
      const std::uint32_t s = owner_[n[k]];
      return static_cast<double>(result.distance[s == none ? slot : s]);
    };
    const double x = 2.0 * (at(0) - at(4)) + at(1) + at(7) - at(3) - at(5);
    const double y = 2.0 * (at(2) - at(6)) + at(1) + at(3) - at(5) - at(7);
    const Frame& frame = surface_.frame(surface_.cell(slot).patch);
    return x * frame.u + y * frame.v;
  }

  void open(std::uint32_t slot) {
    ++result.cracks;
    const auto id = static_cast<std::uint32_t>(result.cracks);
    const double turn = 2.0 * std::numbers::pi * weathering::uniform(settings_.seed, 0, slot, angle_purpose);
    const std::size_t first = result.cells.size();
    mark(slot, id, 0);
    const glm::dvec3 slope = away(slot);
    for (const int side : {1, -1}) {
      LineWalk walk(surface_, unfolding_, slot, turn);
      // Across the strip that older cracks have left, give or take 30 degrees.
      if (glm::length(slope) > 1e-3) {
        walk.steer(slope, 4.0);
        walk.turn((turn / std::numbers::pi - 1.0) * 0.5);
      }
      if (side < 0) walk.turn(std::numbers::pi);
      run(walk, slot, id, side);
    }
    release(first);
  }

  void run(LineWalk& walk, std::uint32_t start, std::uint32_t id, int side) {
    const double step = 0.5 * surface_.cell_size();
    const auto most = static_cast<int>(64.0 * std::sqrt(static_cast<double>(surface_.owned_count())));
    // So many half cells that a turn adds up to `wander` over the spacing.
    const double sway = settings_.wander / std::sqrt(2.0 * spacing_);
    std::uint32_t last = start;
    for (int k = 1; k < most; ++k) {
      const float near = result.distance[last];
      const double u = weathering::uniform(settings_.seed, static_cast<std::uint64_t>(k), 2 * id + (side > 0),
                                           wander_purpose);
      walk.turn(sway * (2.0 * u - 1.0) * std::sqrt(3.0));
      if (near < 0.5f * reach_) {
        const glm::dvec3 slope = away(last);
        // What it runs into it meets squarely; what it leaves behind it does not look back at.
        if (glm::dot(walk.heading(), slope) < 0.0) walk.steer(-slope, settings_.release * 3.0 / spacing_);
      }
      const bool whole = walk.forward(step);
      result.length += step;
      if (!whole) {
        ++result.ends_at_rim;
        return;
      }
      const auto next = walk.cell();
      if (!next) continue;
      if (*next == last) continue;
      if (strain_at(*next) <= 0.0) {
        ++result.ends_free;
        return;
      }
      const std::uint32_t met = meets(*next, id, side * k);
      if (crack_[*next] == 0) mark(*next, id, side * k);
      if (met != none) {
        join(met);
        return;
      }
      last = *next;
    }
    ++result.ends_free;
  }

  void mark(std::uint32_t slot, std::uint32_t id, int when) {
    crack_[slot] = id;
    when_[slot] = when;
    result.cells.push_back(slot);
  }

  // A cell of another crack, or an older one of its own, in or beside `slot`.
  std::uint32_t meets(std::uint32_t slot, std::uint32_t id, int now) const {
    const auto other = [&](std::uint32_t s) {
      return s != none && crack_[s] != 0 && (crack_[s] != id || std::abs(now - when_[s]) > 16);
    };
    if (other(slot)) return slot;
    const auto n = around(surface_, slot);
    for (std::size_t k = 0; k < 8; ++k) {
      const std::size_t at = k < 4 ? 2 * k : 2 * (k - 4) + 1;  // sides first
      if (other(owner_[n[at]])) return owner_[n[at]];
    }
    return none;
  }

  // Ends that meet a crack within two cells of each other make one junction.
  void join(std::uint32_t slot) {
    const auto is_joint = [&](std::uint32_t s) { return s != none && degree_[s] != 0; };
    std::uint32_t at = is_joint(slot) ? slot : none;
    for (const std::uint32_t n : around(surface_, slot)) {
      if (at != none || owner_[n] == none) continue;
      if (is_joint(owner_[n])) at = owner_[n];
      for (const std::uint32_t m : around(surface_, owner_[n]))
        if (at == none && is_joint(owner_[m])) at = owner_[m];
    }
    if (at == none) {
      at = slot;
      joints_.push_back(slot);
    }
    if (degree_[at] < 255) ++degree_[at];
  }

  void release(std::size_t first) {
    weathering::carry_distance(surface_, owner_, std::span(result.cells).subspan(first), result.distance,
                               [](std::uint32_t, std::uint32_t) {});
  }

  const Surface& surface_;
  const CrackSettings& settings_;
  const Field<float>& strain_;
  Unfolding unfolding_;
  double spacing_;                    // cells
  float reach_;                       // cells
  std::vector<std::uint32_t> owner_;  // [slot] the owned cell that it shows
  std::vector<std::uint32_t> crack_;  // [slot] number of the crack there, from 1
  std::vector<std::int32_t> when_;    // [slot] half cells from its origin
  std::vector<std::uint8_t> degree_;  // [slot] ends that joined here
  std::vector<std::uint32_t> joints_;
};

}  // namespace

double CrackNetwork::threes() const {
  const double all = static_cast<double>(junctions[0] + junctions[1] + junctions[2]);
  return all > 0.0 ? static_cast<double>(junctions[0]) / all : 0.0;
}

CrackNetwork grow_cracks(const Surface& surface, const CrackSettings& settings, const Field<float>& strain) {
  if (!(settings.spacing >= 8.0 * surface.cell_size()))
    throw InputError("crack: spacing", fmt::format("{:g} is less than eight cells", settings.spacing),
                     "use a wider spacing, or more cells");
  Network network(surface, settings, strain);
  network.grow();
  return std::move(network.result);
}

}  // namespace verdigris
