#include "verdigris/synthesis/cellular_noise.hpp"

#include <limits>
#include <type_traits>

#include "feature_points.hpp"
#include "lattice_octave.hpp"
#include "point_blocks.hpp"
#include "sampled_values.hpp"

namespace verdigris {

namespace {

using namespace synthesis;

enum class Output { f1, f2, difference };

constexpr float far_away = std::numeric_limits<float>::max();
constexpr int last_ring = 3;  // of cells around a point: with a point in every cell F2 is never farther

// A block's cells along one axis.
struct AxisCells {
  AxisBlock block;
  std::uint32_t key_before[lanes];  ///< of the cell below
};

void split_cells(const LatticeOctave& lattice, std::size_t a, const double* x, AxisCells& cells) {
  split_axis(lattice.axes[a], a, x, cells.block);
  for (std::size_t k = 0; k < lanes; ++k) {
    const std::uint32_t here = cells.block.cell[k];
    cells.key_before[k] = ((here == 0 ? lattice.cells : here) - 1) * axis_key[a];
  }
}

const std::uint32_t* keys(const AxisCells& cells, int offset) {
  return offset < 0 ? cells.key_before : offset == 0 ? cells.block.key_below : cells.block.key_above;
}

std::uint32_t cell_word(std::uint32_t seed, std::uint32_t x_key, std::uint32_t y_key, std::uint32_t z_key) {
  return point_word(plane_word(seed, x_key, y_key), z_key);
}

template <int dimension, Metric metric>
class Cellular final : public ScalarField {
 public:
  Cellular(const LatticeOctave& lattice, Output output, double jitter)
      : lattice_(lattice), output_(output), jitter_(static_cast<float>(jitter)) {
    mean_ = sampled_mean(*this, lattice_.cell(), [](float value) { return value; });
  }
  ValueRange range() const override { return sampled_range(*this, lattice_.cell()); }

 private:
  void compute(const Points& points, double footprint, std::span<float> out) const override {
    const float left = lattice_.fade(footprint);
    for_blocks(points, out, [&](const PointBlock& block, float* value) {
      distances(block, value);
      if (left < 1.0f)
        for (std::size_t k = 0; k < lanes; ++k) value[k] = mean_ + left * (value[k] - mean_);
    });
  }

  void distances(const PointBlock& points, float* __restrict value) const {
    AxisCells axes[3];
    for (std::size_t a = 0; a < dimension; ++a) split_cells(lattice_, a, points.axis[a], axes[a]);
    float f1[lanes], f2[lanes];
    for (std::size_t k = 0; k < lanes; ++k) f1[k] = f2[k] = far_away;
    for (int z = dimension == 3 ? -1 : 0; z <= (dimension == 3 ? 1 : 0); ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) look_into(axes, x, y, z, f1, f2);
    for (std::size_t k = 0; k < lanes; ++k)
      for (int ring = 2; ring <= last_ring; ++ring) {
        // No point beyond the cells seen so far is nearer than their border.
        float border = far_away;
        for (int a = 0; a < dimension; ++a) {
          const float t = axes[a].block.fraction[k], inside = t < 0.5f ? t : 1.0f - t;
          border = inside < border ? inside : border;
        }
        border += static_cast<float>(ring - 1);
        if ((output_ == Output::f1 ? f1[k] : f2[k]) <=
            (metric == Metric::euclidean ? border * border : border))
          break;
        look_around(axes, k, ring, f1[k], f2[k]);
      }
    if constexpr (metric == Metric::euclidean)
      for (std::size_t k = 0; k < lanes; ++k) {
        f1[k] = std::sqrt(f1[k]);
        f2[k] = std::sqrt(f2[k]);
      }
    for (std::size_t k = 0; k < lanes; ++k)
      value[k] = output_ == Output::f1 ? f1[k] : output_ == Output::f2 ? f2[k] : f2[k] - f1[k];
  }

  // The neighbouring cell (x, y, z), each -1..1, of every lane.
  void look_into(const AxisCells* axes, int x, int y, int z, float* __restrict f1,
                 float* __restrict f2) const {
    const std::uint32_t *x_key = keys(axes[0], x), *y_key = keys(axes[1], y);
    const float *fx = axes[0].block.fraction, *fy = axes[1].block.fraction;
    const float mx = static_cast<float>(x) + 0.5f, my = static_cast<float>(y) + 0.5f;
    if constexpr (dimension == 3) {
      const std::uint32_t* z_key = keys(axes[2], z);
      const float* fz = axes[2].block.fraction;
      const float mz = static_cast<float>(z) + 0.5f;
      for (std::size_t k = 0; k < lanes; ++k)
        keep_nearest(feature_distance<3, metric>(cell_word(lattice_.seed, x_key[k], y_key[k], z_key[k]),
                                                 mx - fx[k], my - fy[k], mz - fz[k], jitter_),
                     f1[k], f2[k]);
    } else {
      for (std::size_t k = 0; k < lanes; ++k)
        keep_nearest(feature_distance<2, metric>(cell_word(lattice_.seed, x_key[k], y_key[k], 0), mx - fx[k],
                                                 my - fy[k], 0.0f, jitter_),
                     f1[k], f2[k]);
    }
  }

  // The cells of one ring about lane k.
  void look_around(const AxisCells* axes, std::size_t k, int ring, float& f1, float& f2) const {
    const int deep = dimension == 3 ? ring : 0;
    for (int z = -deep; z <= deep; ++z)
      for (int y = -ring; y <= ring; ++y) {
        const bool face = y == -ring || y == ring || (dimension == 3 && (z == -ring || z == ring));
        for (int x = -ring; x <= ring; x += face ? 1 : 2 * ring) {
          const int offset[3] = {x, y, z};
          std::uint32_t key[3] = {0, 0, 0};
          float middle[3] = {0.0f, 0.0f, 0.0f};
          for (std::size_t a = 0; a < dimension; ++a) {
            key[a] = shifted(axes[a].block.cell[k], offset[a]) * axis_key[a];
            middle[a] = static_cast<float>(offset[a]) + 0.5f - axes[a].block.fraction[k];
          }
          keep_nearest(feature_distance<dimension, metric>(cell_word(lattice_.seed, key[0], key[1], key[2]),
                                                           middle[0], middle[1], middle[2], jitter_),
                       f1, f2);
        }
      }
  }

  std::uint32_t shifted(std::uint32_t cell, int by) const {
    if (lattice_.cells == 0) return cell + static_cast<std::uint32_t>(by);
    const std::int64_t count = lattice_.cells, to = (std::int64_t{cell} + by) % count;
    return static_cast<std::uint32_t>(to < 0 ? to + count : to);
  }

  LatticeOctave lattice_;
  Output output_;
  float jitter_, mean_ = 0.0f;
};

template <int dimension>
std::unique_ptr<ScalarField> of_metric(const CellularNoise& settings, const LatticeOctave& lattice) {
  const Output output = settings.distance == "F1"   ? Output::f1
                        : settings.distance == "F2" ? Output::f2
                                                    : Output::difference;
  if (settings.metric == "manhattan")
    return std::make_unique<Cellular<dimension, Metric::manhattan>>(lattice, output, settings.jitter);
  if (settings.metric == "chebyshev")
    return std::make_unique<Cellular<dimension, Metric::chebyshev>>(lattice, output, settings.jitter);
  return std::make_unique<Cellular<dimension, Metric::euclidean>>(lattice, output, settings.jitter);
}

}  // namespace

std::unique_ptr<ScalarField> CellularNoise::make(std::uint64_t seed) const {
  const LatticeOctave lattice = lattice_octave(frequency, period, seed, 0);
  return dimensions == 2 ? of_metric<2>(*this, lattice) : of_metric<3>(*this, lattice);
}

}  // namespace verdigris
