// Dijkstra's algorithm over cells, each carrying its source unfolded along the way (cf. the windows of
// Mitchell, Mount & Papadimitriou 1987, "The discrete geodesic problem", without their intervals).

#include "verdigris/exposure/line_distance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <queue>

#include "verdigris/base/error.hpp"
#include "verdigris/surface/ghost_values.hpp"
#include "verdigris/surface/walk.hpp"

namespace verdigris {

namespace {

struct Reached {
  double distance = std::numeric_limits<double>::infinity();
  double offset = 0.0;  // from the line to the corner that `source` is, if it is one
  glm::dvec2 source{0.0};
};

class Growth {
 public:
  Growth(const Surface& surface, double most)
      : surface_(surface),
        most_(most),
        unfolding_(surface.frames(), surface.adjacency(), surface.barred_edges()),
        owner_(ghost_sources(surface, none)),
        reached_(surface.slot_count()) {}

  // A point of the line, in space, at the cell nearest to it.
  void start(std::uint32_t slot, glm::dvec3 point) {
    const CellRef c = surface_.cell(slot);
    const glm::dvec2 source = surface_.frame(c.patch).to_plane(point);
    offer(slot, {glm::length(surface_.centre(c.row, c.column) - source), 0.0, source});
  }

  Field<float> run() {
    while (!queue_.empty()) {
      const auto [distance, slot] = queue_.top();
      queue_.pop();
      if (distance == reached_[slot].distance) spread(slot);
    }
    Field<float> field(surface_.slot_count(), static_cast<float>(most_));
    for (std::size_t s = 0; s < field.size(); ++s)
      field[s] = static_cast<float>(std::min(reached_[s].distance, most_));
    copy_to_ghosts(surface_, field);
    return field;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  // Cosines of 45 and 75 degrees: neighbours round a cell are 45 apart, owners of ghosts less evenly spread.
  static constexpr double turn_in_patch = 0.7071, turn_at_edge = 0.26;

  void offer(std::uint32_t slot, const Reached& r) {
    if (!(r.distance < reached_[slot].distance) || r.distance > most_) return;
    reached_[slot] = r;
    queue_.push({r.distance, slot});
  }

  void spread(std::uint32_t slot) {
    const Reached from = reached_[slot];
    const CellRef cell = surface_.cell(slot);
    const glm::dvec2 here = surface_.centre(cell.row, cell.column);
    each_neighbour(cell, [&](std::uint32_t near, bool owned, glm::dvec2 there) {
      if (owned)
        offer(near, reach(from, here, there, turn_in_patch));
      else if (owner_[near] != none)
        cross(cell.patch, here, there, owner_[near], from);
    });
    // And to the cells beside this one's ghosts, which may have no ghost here.
    for (const std::uint32_t ghost : surface_.links().targets(slot)) {
      const CellRef beyond = surface_.cell(ghost);
      const auto motion = motion_between(cell.patch, beyond.patch);
      if (!motion) continue;
      Reached turned = from;
      turned.source = (*motion)(from.source);
      each_neighbour(beyond, [&](std::uint32_t near, bool owned, glm::dvec2 there) {
        if (owned) offer(near, reach(turned, (*motion)(here), there, turn_at_edge));
      });
    }
  }

  // visit(slot, evolving?, centre) for the eight slots around a cell or ghost, where there are any.
  template <typename Visit>
  void each_neighbour(const CellRef& cell, Visit&& visit) const {
    const std::uint32_t first = surface_.row_begin(cell.patch), last = surface_.row_end(cell.patch);
    for (int dy = -1; dy <= 1; ++dy) {
      const std::int64_t row = static_cast<std::int64_t>(first) + 1 + cell.row + dy;
      if (row < first || row >= last) continue;
      const Row& r = surface_.rows()[static_cast<std::size_t>(row)];
      const std::uint32_t end = row + 1 < static_cast<std::int64_t>(surface_.rows().size())
                                    ? surface_.rows()[static_cast<std::size_t>(row) + 1].begin
                                    : static_cast<std::uint32_t>(surface_.slot_count());
      for (int dx = -1; dx <= 1; ++dx) {
        const std::uint32_t near = r.base + static_cast<std::uint32_t>(cell.column + dx);
        if ((dx == 0 && dy == 0) || near < r.begin || near >= end) continue;
        visit(near, near >= r.run_begin && near < r.run_end,
              surface_.centre(cell.row + dy, cell.column + dx));
      }
    }
  }

  // The state of a cell at `there` that is reached from one at `here`. Where the way turns off the straight
  // line from the source, it leads round something: its corner is here.
  Reached reach(const Reached& from, glm::dvec2 here, glm::dvec2 there, double least_cosine) const {
    const glm::dvec2 step = there - here, along = here - from.source;
    const double length = glm::length(step), radius = glm::length(along);
    if (radius < 2.5 * surface_.cell_size() || glm::dot(step, along) >= least_cosine * length * radius) {
      const double straight = from.offset + glm::length(there - from.source);
      return {std::max(straight, from.distance), from.offset, from.source};
    }
    return {from.distance + length, from.distance, here};
  }

  // Over an edge: to the owner of the ghost at `there`, with the source turned into its plane.
  void cross(std::uint32_t patch, glm::dvec2 here, glm::dvec2 there, std::uint32_t owner,
             const Reached& from) {
    const auto landing = unfolding_.walk(patch, here, there);
    if (!landing) return;
    const CellRef cell = surface_.cell(owner);
    const auto beside = motion_between(landing->patch, cell.patch);
    if (!beside) {
      // Past triangles that own no cell: from here on.
      const glm::dvec3 at = surface_.frame(patch).to_model(here);
      const glm::dvec2 corner = surface_.frame(cell.patch).to_plane(at);
      offer(owner, {from.distance + glm::length(surface_.position(owner) - at), from.distance, corner});
      return;
    }
    const Motion motion = then(landing->motion, *beside);
    Reached turned = from;
    turned.source = motion(from.source);
    offer(owner, reach(turned, motion(here), surface_.centre(cell.row, cell.column), turn_at_edge));
  }

  // From the plane of one patch to that of another near it: the nearest cell to a point need not belong to
  // the triangle that the point lies in.
  std::optional<Motion> motion_between(std::uint32_t from, std::uint32_t to) const {
    struct Visit {
      std::uint32_t patch;
      Motion motion;
    };
    constexpr std::size_t most_visits = 40;
    std::array<Visit, most_visits + 3> queue;
    std::size_t count = 0;
    queue[count++] = {from, {}};
    for (std::size_t k = 0; k < count && count < most_visits; ++k) {
      if (queue[k].patch == to) return queue[k].motion;
      for (int edge = 0; edge < 3; ++edge) {
        const std::uint32_t across = unfolding_.across(queue[k].patch, edge);
        if (across == Adjacency::none) continue;
        const std::uint32_t next = across / 3;
        if (std::any_of(queue.begin(), queue.begin() + count,
                        [&](const Visit& v) { return v.patch == next; }))
          continue;
        const Motion m =
            unfold(surface_.frame(queue[k].patch), edge, surface_.frame(next), unfolding_.frame_edge(across));
        queue[count++] = {next, then(queue[k].motion, m)};
      }
    }
    return std::nullopt;
  }

  struct Entry {
    double distance;
    std::uint32_t slot;
    bool operator>(const Entry& o) const {
      return distance != o.distance ? distance > o.distance : slot > o.slot;
    }
  };

  const Surface& surface_;
  double most_;
  Unfolding unfolding_;
  std::vector<std::uint32_t> owner_;  // [slot] of ghosts
  std::vector<Reached> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

// Points along the lines, half a cell apart.
std::vector<glm::dvec3> dotted(std::span<const PaintedLine> lines, double cell_size) {
  std::vector<glm::dvec3> dots;
  for (const PaintedLine& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (!std::isfinite(line[k].x + line[k].y + line[k].z))
        throw InputError("painted lines", "a coordinate is not finite", "give three numbers a point");
      dots.push_back(line[k]);
      if (k + 1 == line.size()) break;
      const double pieces = std::ceil(2.0 * glm::length(line[k + 1] - line[k]) / cell_size);
      if (pieces > 1e7)
        throw InputError("painted lines", "a line is longer than five million cells", "use larger cells");
      for (double j = 1.0; j < pieces; ++j) dots.push_back(line[k] + j / pieces * (line[k + 1] - line[k]));
    }
  return dots;
}

}  // namespace

Field<float> line_distance(const Surface& surface, std::span<const PaintedLine> lines, double most) {
  const std::vector<glm::dvec3> dots = dotted(lines, surface.cell_size());
  if (dots.empty()) throw InputError("painted lines", "there is no point", "give at least one");
  if (surface.link_kind() != LinkKind::unfolded)
    throw InputError("painted lines", "distances need unfolded links", "use them, or another mask");
  Growth growth(surface, most);
  const std::vector<LocatedCell> cells = locate(surface, dots);
  for (std::size_t k = 0; k < dots.size(); ++k) growth.start(cells[k].slot, dots[k]);
  return growth.run();
}

std::vector<PaintedLine> parse_lines(std::string_view text, std::string_view where) {
  std::vector<PaintedLine> lines(1);
  std::size_t at = 0;
  const auto blanks = [&] {
    while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || text[at] == '\n')) ++at;
  };
  for (blanks(); at < text.size(); blanks()) {
    glm::dvec3 p(0.0);
    for (int k = 0; k < 3; ++k) {
      blanks();
      const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), p[k]);
      if (error != std::errc() || !std::isfinite(p[k]))
        throw InputError(fmt::format("{}, column {}", where, at + 1), "there is no number here",
                         "give points as \"x y z, x y z\", lines separated by ';'");
      at = static_cast<std::size_t>(end - text.data());
    }
    lines.back().push_back(p);
    blanks();
    if (at == text.size()) break;
    if (text[at] != ',' && text[at] != ';')
      throw InputError(fmt::format("{}, column {}", where, at + 1),
                       fmt::format("'{}' does not belong here", text[at]),
                       "separate points by ',' and lines by ';'");
    if (text[at] == ';') lines.emplace_back();
    ++at;
  }
  std::erase_if(lines, [](const PaintedLine& line) { return line.empty(); });
  if (lines.empty())
    throw InputError(std::string(where), "there is no point", "give points as \"x y z, x y z\"");
  return lines;
}

}  // namespace verdigris
