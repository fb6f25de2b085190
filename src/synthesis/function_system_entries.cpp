#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "entries.hpp"
#include "grid_field.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/function_system.hpp"

namespace verdigris {

namespace {

// 1 on the attractor, falling to 0 at some distance.
class NearnessField final : public ScalarField {
 public:
  NearnessField(const FunctionSystem& system, double falloff)
      : distance_(system, 0.02 * falloff), flat_(system.dimension == 2), falloff_(falloff) {
    // A cube round a sample of the attractor; the ball would leave much room.
    glm::dvec3 low = distance_.ball().centre, high = low;
    for (const glm::dvec3& p : chaos_game(system, 16384, 1)) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    const glm::dvec3 size = high - low, middle = 0.5 * (low + high);
    const double half = 0.5 * std::max({size.x, size.y, size.z}) + falloff;
    window_ = {middle - half, middle + half};
  }

  ValueRange range() const override { return {0.0f, 1.0f, true}; }
  Window window() const override { return window_; }

 private:
  void compute(const Points& points, double footprint, std::span<float> out) const override {
    // A slope over two footprints at least cannot alias.
    const double falloff = std::max(falloff_, 2.0 * footprint);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const glm::dvec3 p(points.x[k], points.y.empty() ? 0.0 : points.y[k],
                         flat_ || points.z.empty() ? 0.0 : points.z[k]);
      out[k] = static_cast<float>(1.0 - distance_(p, falloff) / falloff);
    }
  }

  AttractorDistance distance_;
  bool flat_;
  double falloff_;
  Window window_;
};

std::unique_ptr<ScalarField> nearness_field(const FunctionSystem& system, double falloff) {
  const Ball ball = attractor_ball(system);
  // A set may be a single point.
  const double least = 1e-9 * (1.0 + glm::length(ball.centre));
  return std::make_unique<NearnessField>(system, std::max(falloff * ball.radius, least));
}

// How often the chaos game visits the squares of a grid, on a logarithmic scale.
std::unique_ptr<ScalarField> density_field(const FunctionSystem& system, int side, double samples,
                                           std::uint64_t seed) {
  const std::vector<glm::dvec3> points = chaos_game(system, static_cast<std::size_t>(samples), seed);
  glm::dvec2 low(points[0]), high = low;
  for (const glm::dvec3& p : points) {
    low = glm::min(low, glm::dvec2(p));
    high = glm::max(high, glm::dvec2(p));
  }
  // A set may be a single point.
  const double least = 1e-9 * (1.0 + glm::length(0.5 * (low + high)));
  const double extent = 1.05 * std::max({high.x - low.x, high.y - low.y, least});
  const glm::dvec2 origin = 0.5 * (low + high) - 0.5 * extent;
  std::vector<double> counts(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0.0);
  // Far from the origin points are coarser than the squares of a small set: some would miss the grid.
  const auto nearest = [&](double along) {
    return static_cast<std::size_t>(std::clamp(along / extent, 0.0, 1.0) * (side - 1) + 0.5);
  };
  for (const glm::dvec3& p : points)
    counts[nearest(p.y - origin.y) * static_cast<std::size_t>(side) + nearest(p.x - origin.x)] += 1.0;
  for (double& count : counts) count = std::log1p(count);
  const Window window{{origin.x, origin.y, -0.5 * extent},
                      {origin.x + extent, origin.y + extent, 0.5 * extent}};
  return std::make_unique<synthesis::GridField>(synthesis::to_unit_range(counts), side, side,
                                                synthesis::Beyond::zero, window);
}

struct FunctionSystemParameters {
  std::string maps, measure = "distance";
  double falloff = 0.02, samples = 2e6;
  int levels = 9;

  template <typename V>
  void shared(V&& v) {
    v("measure", measure, {"distance", "density"},
      "distance: 1 on the set, falling to 0; density: how often the chaos game comes by (plane only)");
    v("falloff", falloff, 1e-3, 10.0, "1", "distance at which it is 0, as a share of the set's radius");
    v("levels", levels, 4, 12, "1", "density: 2^levels + 1 points along a side");
    v("samples", samples, 1e3, 1e8, "1", "density: points of the chaos game");
  }
  std::unique_ptr<ScalarField> field(const FunctionSystem& system, std::uint64_t seed,
                                     const std::string& owner) const {
    if (measure == "distance") return nearness_field(system, falloff);
    if (system.dimension != 2)
      throw InputError(owner + ".measure", "densities are of sets in the plane", "choose distance");
    return density_field(system, (1 << levels) + 1, samples, seed);
  }
};

template <int which>
struct NamedSystem : FunctionSystemParameters {
  static constexpr const char* name = which == 0   ? "sierpinski-triangle"
                                      : which == 1 ? "sierpinski-tetrahedron"
                                      : which == 2 ? "menger-sponge"
                                                   : "barnsley-fern";
  static constexpr const char* summary = which == 0   ? "three half-size copies of itself"
                                         : which == 1 ? "four half-size copies of itself, in space"
                                         : which == 2 ? "twenty copies of itself a third as large, in space"
                                                      : "a fern of four copies of itself";
  static constexpr int dimension = which == 1 || which == 2 ? 3 : 2;
  NamedSystem() {
    if (which == 3) measure = "density";
  }
  template <typename V>
  void parameters(V&& v) {
    shared(v);
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const {
    return field(named_function_system(name), seed, name);
  }
};

struct OwnSystem : FunctionSystemParameters {
  static constexpr const char *name = "ifs", *summary = "an iterated function system of your own maps";
  static constexpr int dimension = 3;
  // Heighway's dragon: two copies, turned by 45 and 135 degrees.
  OwnSystem() { maps = "0.5 -0.5 0.5 0.5 0 0; -0.5 -0.5 0.5 -0.5 1 0"; }
  template <typename V>
  void parameters(V&& v) {
    v("maps", maps, {},
      "maps between semicolons or on lines, 6 numbers a b c d e f for (a x + b y + e, c x + d y + f) or 12 "
      "in "
      "space; one more is the weight");
    shared(v);
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const {
    return field(parse_function_system(maps, "ifs.maps"), seed, name);
  }
};

}  // namespace

void add_function_systems(PrimitiveCatalogue& catalogue) {
  catalogue.add(primitive_entry<NamedSystem<0>>());
  catalogue.add(primitive_entry<NamedSystem<1>>());
  catalogue.add(primitive_entry<NamedSystem<2>>());
  catalogue.add(primitive_entry<NamedSystem<3>>());
  catalogue.add(primitive_entry<OwnSystem>());
}

}  // namespace verdigris
