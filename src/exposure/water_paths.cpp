// Sharing water between cells so that its mean goes where the slope leads: cf. Tarboton 1997, "A new method
// for the determination of flow directions and upslope areas in grid digital elevation models".

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "descent.hpp"
#include "ray_scene.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/water.hpp"
#include "verdigris/surface/ghost_values.hpp"
#include "verdigris/surface/surface_point.hpp"
#include "verdigris/synthesis/fractal_noise.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t no_slot = 0xFFFFFFFFu;

// Cells that share water, and how.
struct Shares {
  std::array<std::uint32_t, 4> slot{};
  std::array<double, 4> share{};
  std::array<glm::dvec2, 4> off{};  // from where the water arrives to their centres
  int count = 0;

  void add(std::uint32_t s, double w, glm::dvec2 o) {
    for (int k = 0; k < count; ++k)
      if (slot[static_cast<std::size_t>(k)] == s) {
        share[static_cast<std::size_t>(k)] += w;
        return;
      }
    const auto k = static_cast<std::size_t>(count++);
    slot[k] = s, share[k] = w, off[k] = o;
  }

  void normalise() {
    double sum = 0.0;
    for (int k = 0; k < count; ++k) sum += share[static_cast<std::size_t>(k)];
    for (int k = 0; k < count; ++k) share[static_cast<std::size_t>(k)] /= sum;
  }

  // The least change of shares after which their mean lies where the water arrives, if there is one that
  // leaves none below 0.
  void centre() {
    glm::dvec2 mean(0.0);
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) mean += share[k] * off[k];
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      const glm::dvec2 d = off[k] - mean;
      xx += share[k] * d.x * d.x, xy += share[k] * d.x * d.y, yy += share[k] * d.y * d.y;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-6 * (xx + yy) * (xx + yy))) return;
    const glm::dvec2 pull = glm::dvec2(yy * mean.x - xy * mean.y, xx * mean.y - xy * mean.x) / determinant;
    std::array<double, 4> changed = share;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      changed[k] *= 1.0 - glm::dot(off[k] - mean, pull);
      if (changed[k] < 0.0) return;
    }
    share = changed;
  }
};

class PathMaker {
 public:
  PathMaker(const Surface& surface, const WaterPathSettings& settings, glm::dvec3 up)
      : surface_(surface),
        settings_(settings),
        up_(up),
        descent_(surface, up),
        scene_(surface.mesh()),
        owner_(ghost_sources(surface, no_slot)),
        height_(surface.slot_count(), 0.0) {
    drip_length_ = settings.drip_length > 0.0 ? settings.drip_length : 0.05 * scene_.diagonal();
  }

  WaterPaths run() {
    WaterPaths paths;
    paths.cell_size = surface_.cell_size();
    for (std::uint32_t r = 0; r < surface_.rows().size(); ++r)
      for (std::uint32_t slot = surface_.owned(r).begin; slot < surface_.owned(r).end; ++slot)
        paths.slots.push_back(slot);
    std::vector<std::uint32_t>& slots = paths.slots;
    tbb::parallel_for(std::size_t{0}, slots.size(),
                      [&](std::size_t k) { height_[slots[k]] = glm::dot(up_, surface_.position(slots[k])); });
    tbb::parallel_sort(slots.begin(), slots.end(), [&](std::uint32_t a, std::uint32_t b) {
      return height_[a] != height_[b] ? height_[a] > height_[b] : a < b;
    });
    std::vector<std::uint32_t> rank(surface_.slot_count(), no_slot);
    for (std::uint32_t k = 0; k < slots.size(); ++k) rank[slots[k]] = k;
    const std::vector<float> turns = meander(slots);
    paths.cells.resize(slots.size());
    tbb::parallel_for(std::size_t{0}, slots.size(), [&](std::size_t k) {
      WaterPaths::Cell cell = path(slots[k], turns.empty() ? 0.0 : static_cast<double>(turns[k]));
      for (std::uint32_t& to : cell.to)
        if (to < WaterPaths::drained) to = rank[to];
      if (cell.drip_to < WaterPaths::drained) cell.drip_to = rank[cell.drip_to];
      paths.cells[k] = cell;
    });
    return paths;
  }

 private:
  // Angles [cell] by which roughness turns the water.
  std::vector<float> meander(const std::vector<std::uint32_t>& slots) const {
    if (!(settings_.meander > 0.0)) return {};
    const double size = settings_.meander_size > 0.0 ? settings_.meander_size : 12.0 * surface_.cell_size();
    Fbm noise;
    noise.lattice.frequency = 1.0 / size;
    noise.series.octaves = 3;
    const auto field = noise.make(settings_.seed);
    std::vector<float> turns(slots.size());
    constexpr std::size_t block = 4096;
    tbb::parallel_for(std::size_t{0}, (slots.size() + block - 1) / block, [&](std::size_t b) {
      const std::size_t first = b * block, count = std::min(block, slots.size() - first);
      std::vector<double> x(count), y(count), z(count);
      for (std::size_t k = 0; k < count; ++k) {
        const glm::dvec3 p = surface_.position(slots[first + k]);
        x[k] = p.x, y[k] = p.y, z[k] = p.z;
      }
      field->evaluate({x, y, z}, surface_.cell_size(), {turns.data() + first, count});
    });
    // The noise deviates by about 0.3.
    const double scale = settings_.meander * std::numbers::pi / 180.0 / 0.3;
    for (float& t : turns) t = static_cast<float>(std::clamp(scale * t, -1.2, 1.2));
    return turns;
  }

  bool lower(std::uint32_t slot, std::uint32_t than) const {
    return height_[slot] < height_[than] - 1e-12 * scene_.diagonal();
  }

  // The cells around a point, those that lie lower than `from`.
  Shares around(std::uint32_t patch, glm::dvec2 p, std::uint32_t from) const {
    Shares shares;
    bool all = true;
    const double size = surface_.cell_size(), x = p.x / size - 0.5, y = p.y / size - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const std::uint32_t first = surface_.row_begin(patch), last = surface_.row_end(patch);
    for (int k = 0; k < 4; ++k) {
      const int dx = k & 1, dy = k >> 1;
      const double w = (dx != 0 ? x - x0 : 1.0 - (x - x0)) * (dy != 0 ? y - y0 : 1.0 - (y - y0));
      const auto row = static_cast<std::int64_t>(y0) + dy + 1 + first;
      std::uint32_t slot = no_slot;
      if (row >= first && row < last) {
        const auto rows = surface_.rows();
        const auto index = static_cast<std::size_t>(row);
        const Row& r = rows[index];
        const std::size_t end = index + 1 < rows.size() ? rows[index + 1].begin : surface_.slot_count();
        const std::uint32_t at = r.base + static_cast<std::uint32_t>(static_cast<std::int32_t>(x0) + dx);
        if (at >= r.run_begin && at < r.run_end)
          slot = at;
        else if (at >= r.begin && at < end)
          slot = owner_[at];
      }
      if (slot == no_slot || !lower(slot, from)) {
        all = false;
        continue;
      }
      if (w > 0.0) shares.add(slot, w, surface_.frame(patch).to_plane(surface_.position(slot)) - p);
    }
    if (shares.count == 0) {
      const auto cell = cell_at(surface_, {patch, p});
      if (cell && lower(*cell, from)) shares.add(*cell, 1.0, glm::dvec2(0.0));
      return shares;
    }
    shares.normalise();
    if (all) shares.centre();
    return shares;
  }

  // Where a drop from `p` lands: a cell lower than `from`, or `else_`.
  std::uint32_t landing(glm::dvec3 p, std::uint32_t from, std::uint32_t else_) const {
    const auto hit = scene_.first(p, -up_);
    if (!hit) return else_;
    const auto cell = cell_at(surface_, {hit->triangle, surface_.frame(hit->triangle).to_plane(hit->point)});
    return cell && lower(*cell, from) ? *cell : else_;
  }

  WaterPaths::Cell path(std::uint32_t slot, double turn) const {
    const CellRef at = surface_.cell(slot);
    const glm::dvec2 start = surface_.centre(at.row, at.column);
    const double size = surface_.cell_size();
    const Frame& frame = surface_.frame(at.patch);
    WaterPaths::Cell cell{};
    cell.to.fill(WaterPaths::stays);
    cell.share = {1.0f, 0.0f, 0.0f, 0.0f};
    cell.drip_to = WaterPaths::dripped;
    Fall fall;
    Shares shares;
    // Where the next cells are no lower, in a valley that falls gently, they are looked for farther on.
    for (double length = 1.5 * size; length < 100.0 * size; length *= 2.0) {
      fall = descent_.run(at.patch, start, length, turn);
      if (fall.end == Fall::End::boundary) break;
      shares = around(fall.patch, fall.point, slot);
      if (shares.count > 0 || fall.end == Fall::End::hollow) break;
    }
    cell.length = static_cast<float>(std::max(fall.length, 0.5 * size));
    const glm::dvec3 lifted = frame.to_model(start) + scene_.lift() * frame.normal();
    if (fall.end == Fall::End::boundary) {
      // Off the edge, half a cell beyond it.
      const Frame& edge = surface_.frame(fall.patch);
      glm::dvec2 out = fall.point - (edge.corner(0) + edge.corner(1) + edge.corner(2)) / 3.0;
      const double length = glm::length(out);
      if (length > 0.0) out *= 0.1 * size / length;
      cell.to[0] = landing(edge.to_model(fall.point + out) - scene_.lift() * up_, slot, WaterPaths::drained);
      return cell;
    }
    const double ceiling = std::max(0.0, -descent_.facing(at.patch));
    double drips = 1.0 - std::exp(-ceiling * cell.length / drip_length_);
    if (fall.rim) drips += (1.0 - drips) * settings_.rim_share;
    if (shares.count == 0 && descent_.facing(fall.patch) < -0.05) drips = 1.0;
    if (drips > 1e-4) {
      cell.drip_share = static_cast<float>(drips);
      cell.drip_to = landing(lifted, slot, WaterPaths::dripped);
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(shares.count); ++k) {
      cell.to[k] = shares.slot[k];
      cell.share[k] = static_cast<float>(shares.share[k]);
    }
    return cell;
  }

  const Surface& surface_;
  const WaterPathSettings& settings_;
  glm::dvec3 up_;
  Descent descent_;
  RayScene scene_;
  std::vector<std::uint32_t> owner_;  // [slot] of ghosts
  std::vector<double> height_;        // [slot] of owned cells
  double drip_length_;
};

}  // namespace

WaterPaths make_water_paths(const Surface& surface, const WaterPathSettings& s) {
  const double length = glm::length(s.up);
  if (!(length > 0.0) || !std::isfinite(length))
    throw InputError("up", "the direction has no length", "give three numbers that are not all 0");
  if (!(s.meander >= 0.0 && s.meander <= 60.0))
    throw InputError("meander", "it is not an angle from 0 to 60 degrees", "use 0 for none, 15 for rivulets");
  if (!(s.meander_size >= 0.0) || !(s.drip_length >= 0.0) || !(s.rim_share >= 0.0 && s.rim_share <= 1.0))
    throw InputError("water", "a length is below 0, or the share at rims not from 0 to 1",
                     "use 0 for lengths that suit the model");
  if (surface.link_kind() != LinkKind::unfolded)
    throw InputError("water", "it needs unfolded links", "use them, or another mask");
  return PathMaker(surface, s, s.up / length).run();
}

}  // namespace verdigris
