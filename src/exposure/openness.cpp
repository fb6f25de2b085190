// Directions: the R2 sequence (Roberts 2018), even whatever part of it is taken, shifted for each sample by
// random numbers of its own (Cranley & Patterson 1976), so that errors are noise without a pattern. Cosine
// weights by Malley's method: points of a disc, lifted.

#include "verdigris/exposure/openness.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "ray_scene.hpp"
#include "sample_mesh.hpp"
#include "verdigris/automaton/random.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

// Two unit vectors square to `n` and each other (Duff et al. 2017).
void make_basis(glm::dvec3 n, glm::dvec3& s, glm::dvec3& t) {
  const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
  s = {1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  t = {b, sign + n.y * n.y * a, -n.y};
}

// The points of a sample in the unit disc.
struct DiscPoints {
  double shift_u, shift_v;

  DiscPoints(std::uint64_t seed, std::uint32_t sample) {
    const auto words = CellRandom(seed, 0, sample).words(0x0A0u);
    shift_u = words[0] / 4294967296.0;
    shift_v = words[1] / 4294967296.0;
  }
  glm::dvec2 operator()(std::uint32_t i) const {
    double u = i * 0.7548776662466927 + shift_u, v = i * 0.5698402909980532 + shift_v;
    u -= std::floor(u), v -= std::floor(v);
    const double r = std::sqrt(u), angle = 2.0 * std::numbers::pi * v;
    return {r * std::cos(angle), r * std::sin(angle)};
  }
};

class Openness {
 public:
  Openness(const Surface& surface, const RaySettings& settings)
      : surface_(surface),
        settings_(settings),
        scene_(surface.mesh()),
        mesh_(surface, settings.crease_angle),
        finest_(settings.finest > 0.0 ? settings.finest : 3.0 * surface.cell_size()) {}

  const RayScene& scene() const { return scene_; }

  // Where rays of a sample start: off the surface, and off a crease into the triangles it belongs to.
  glm::dvec3 start(const Sample& s) const {
    const double length = glm::length(s.inward);
    if (!(length > 0.0)) return s.position + scene_.lift() * s.normal;
    const glm::dvec3 inward = s.inward / length;
    return s.position + scene_.lift() * (s.normal + inward - glm::dot(inward, s.normal) * s.normal);
  }

  // A direction about the mean normal may lead into the triangles that meet at the sample; it is folded up.
  glm::dvec3 fold(const Sample& s, glm::dvec3 d) const {
    if (s.faces[0] == SampleMesh::none) return d;
    const glm::dvec3 m = surface_.frame(s.faces[0]).normal();
    const double below = glm::dot(d, m);
    if (below >= 0.0) return d;
    if (s.faces[1] != SampleMesh::none) {
      const glm::dvec3 n = surface_.frame(s.faces[1]).normal();
      const double other = glm::dot(d, n);
      if (other >= 0.0) return d;
      if (other < below) return d - 2.0 * other * n;
    }
    return d - 2.0 * below * m;
  }

  // value(sample, index, rays) for all samples, refining where it changes.
  template <typename Value>
  Field<float> run(Value&& value) {
    constexpr int most_passes = 10;
    mesh_.refine_to(std::max(scene_.diagonal() / 40.0, finest_));
    std::vector<float> values;
    for (int pass = 0; pass < most_passes; ++pass) {
      const std::size_t first = values.size();
      values.resize(mesh_.samples().size());
      tbb::parallel_for(first, values.size(), [&](std::size_t k) {
        values[k] = static_cast<float>(value(mesh_.samples()[k], static_cast<std::uint32_t>(k)));
      });
      const auto differs = [&](std::uint32_t a, std::uint32_t b) {
        return std::abs(values[a] - values[b]) > settings_.tolerance && mesh_.edge_length(a, b) > finest_;
      };
      if (mesh_.refine(differs) == 0) break;
    }
    // The last pass may have left samples without a value: those between two that have one.
    if (values.size() < mesh_.samples().size()) {
      const std::size_t first = values.size();
      values.resize(mesh_.samples().size());
      tbb::parallel_for(first, values.size(), [&](std::size_t k) {
        values[k] = static_cast<float>(value(mesh_.samples()[k], static_cast<std::uint32_t>(k)));
      });
    }
    smooth(values);
    return values_at_cells(surface_, mesh_, values);
  }

  // The noise of too few rays is less than the tolerance: neighbours that differ by less are averaged.
  // Samples on a border of the smooth surface have neighbours on one side only; the mean with them would lean
  // that way, so they are averaged along the border.
  void smooth(std::vector<float>& values) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(3 * mesh_.pieces().size());
    for (const SampleMesh::Piece& piece : mesh_.pieces())
      for (std::size_t k = 0; k < 3; ++k)
        edges.push_back(std::minmax({piece.samples[k], piece.samples[(k + 1) % 3]}));
    tbb::parallel_sort(edges.begin(), edges.end());
    std::vector<bool> at_border(values.size(), false);
    const auto once = [&](std::size_t k) {
      return (k == 0 || edges[k - 1] != edges[k]) && (k + 1 == edges.size() || edges[k + 1] != edges[k]);
    };
    for (std::size_t k = 0; k < edges.size(); ++k)
      if (once(k)) at_border[edges[k].first] = at_border[edges[k].second] = true;
    constexpr int passes = 2;
    std::vector<float> sum(values.size()), weight(values.size());
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t k = 0; k < values.size(); ++k) sum[k] = 4.0f * values[k], weight[k] = 4.0f;
      for (std::size_t k = 0; k < edges.size(); ++k) {
        const auto [a, b] = edges[k];
        if (std::abs(values[a] - values[b]) > settings_.tolerance) continue;
        const bool border = once(k);
        if (!at_border[a] || border) sum[a] += values[b], weight[a] += 1.0f;
        if (!at_border[b] || border) sum[b] += values[a], weight[b] += 1.0f;
      }
      for (std::size_t k = 0; k < values.size(); ++k) values[k] = sum[k] / weight[k];
    }
  }

  // The mean of visible(ray) over the rays of a sample: a quarter of them, and all where those differ.
  template <typename Visible>
  double mean(std::uint32_t sample, Visible&& visible) const {
    const auto count = static_cast<std::uint32_t>(settings_.rays);
    const DiscPoints points(settings_.seed, sample);
    double sum = 0.0;
    bool same = true;
    float first = 0.0f;
    std::uint32_t made = 0;
    for (std::uint32_t most : {count / 4, count}) {
      for (; made < most; ++made) {
        const double v = visible(points(made));
        if (made == 0) first = static_cast<float>(v);
        same = same && static_cast<float>(v) == first;
        sum += v;
      }
      if (same) break;
    }
    return sum / made;
  }

 private:
  const Surface& surface_;
  const RaySettings& settings_;
  RayScene scene_;
  SampleMesh mesh_;
  double finest_;
};

void check(const RaySettings& s) {
  if (s.rays < 16 || s.rays > 65536)
    throw InputError("rays", std::to_string(s.rays) + " rays", "use 16 to 65536");
  if (!(s.tolerance > 0.0) || !(s.finest >= 0.0) || !(s.crease_angle >= 0.0))
    throw InputError("rays", "tolerance, finest and crease angle are lengths of no use",
                     "use a tolerance above 0, the others 0 or more");
}

glm::dvec3 unit(glm::dvec3 d, const char* name) {
  const double length = glm::length(d);
  if (!(length > 0.0) || !std::isfinite(length))
    throw InputError(name, "the direction has no length", "give three numbers that are not all 0");
  return d / length;
}

}  // namespace

Field<float> ambient_occlusion(const Surface& surface, const RaySettings& rays) {
  check(rays);
  Openness openness(surface, rays);
  return openness.run([&](const Sample& s, std::uint32_t k) {
    glm::dvec3 u, v;
    make_basis(s.normal, u, v);
    const glm::dvec3 from = openness.start(s);
    return openness.mean(k, [&](glm::dvec2 p) {
      const double z = std::sqrt(std::max(0.0, 1.0 - p.x * p.x - p.y * p.y));
      return openness.scene().occluded(from, openness.fold(s, p.x * u + p.y * v + z * s.normal)) ? 0.0 : 1.0;
    });
  });
}

Field<float> sky_view(const Surface& surface, glm::dvec3 up, const RaySettings& rays) {
  check(rays);
  up = unit(up, "up");
  Openness openness(surface, rays);
  return openness.run([&](const Sample& s, std::uint32_t k) {
    glm::dvec3 u, v;
    make_basis(s.normal, u, v);
    const glm::dvec3 from = openness.start(s);
    return openness.mean(k, [&](glm::dvec2 p) {
      const double z = std::sqrt(std::max(0.0, 1.0 - p.x * p.x - p.y * p.y));
      const glm::dvec3 d = openness.fold(s, p.x * u + p.y * v + z * s.normal);
      return glm::dot(d, up) <= 0.0 || openness.scene().occluded(from, d) ? 0.0 : 1.0;
    });
  });
}

Field<float> rain_exposure(const Surface& surface, const RainDirection& rain, const RaySettings& rays) {
  check(rays);
  if (!(rain.spread >= 0.0 && rain.spread < 90.0))
    throw InputError("rain spread", "it is not an angle below 90 degrees", "use 0 to 89");
  const glm::dvec3 towards = unit(rain.towards, "rain direction");
  // Drops of the cone fall on equal areas of the plane square to its axis.
  const double radius = std::sin(rain.spread * std::numbers::pi / 180.0);
  glm::dvec3 u, v;
  make_basis(towards, u, v);
  Openness openness(surface, rays);
  return openness.run([&](const Sample& s, std::uint32_t k) {
    const glm::dvec3 from = openness.start(s);
    return openness.mean(k, [&](glm::dvec2 p) {
      p *= radius;
      const glm::dvec3 d =
          p.x * u + p.y * v + std::sqrt(std::max(0.0, 1.0 - p.x * p.x - p.y * p.y)) * towards;
      const double cosine = glm::dot(d, s.normal);
      if (cosine <= 0.0) return 0.0;
      return openness.scene().occluded(from, openness.fold(s, d)) ? 0.0 : cosine;
    });
  });
}

}  // namespace verdigris
