#include <algorithm>
#include <array>
#include <cmath>

#include "entries.hpp"
#include "verdigris/synthesis/escape_time.hpp"

namespace verdigris {

namespace {

// Counts on a logarithmic scale, 0 at the first iteration, 1 inside. Footprints are served by the mean of
// four samples within them.
class EscapeField final : public ScalarField {
 public:
  EscapeField(bool julia, glm::dvec2 c, const EscapeOptions& options, const Window& window)
      : julia_(julia), c_(c), options_(options), window_(window) {}

  ValueRange range() const override { return {0.0f, 1.0f, true}; }
  Window window() const override { return window_; }

 private:
  void compute(const Points& points, double footprint, std::span<float> out) const override {
    constexpr std::size_t block = 256;
    std::array<double, block> x, y, count, mean;
    const int samples = footprint > 0.0 ? 4 : 1;
    const double scale = 1.0 / std::log1p(static_cast<double>(options_.most_iterations));
    for (std::size_t first = 0; first < points.size(); first += block) {
      const std::size_t n = std::min(block, points.size() - first);
      mean.fill(0.0);
      for (int s = 0; s < samples; ++s) {
        const double dx = samples == 1 ? 0.0 : (s % 2 == 0 ? -0.25 : 0.25) * footprint;
        const double dy = samples == 1 ? 0.0 : (s / 2 == 0 ? -0.25 : 0.25) * footprint;
        for (std::size_t k = 0; k < n; ++k) {
          x[k] = points.x[first + k] + dx;
          y[k] = (points.y.empty() ? 0.0 : points.y[first + k]) + dy;
        }
        if (julia_)
          julia_counts({x.data(), n}, {y.data(), n}, c_, options_, {count.data(), n});
        else
          mandelbrot_counts({x.data(), n}, {y.data(), n}, options_, {count.data(), n});
        for (std::size_t k = 0; k < n; ++k) mean[k] += std::log1p(count[k]) * scale / samples;
      }
      for (std::size_t k = 0; k < n; ++k) out[first + k] = static_cast<float>(std::clamp(mean[k], 0.0, 1.0));
    }
  }

  bool julia_;
  glm::dvec2 c_;
  EscapeOptions options_;
  Window window_;
};

struct EscapeParameters {
  double centre_x = 0.0, centre_y = 0.0, extent = 3.0, radius = 16.0;
  int iterations = 256;

  template <typename V>
  void shared(V&& v) {
    v("iterations", iterations, 1, 1000000, "1", "points that stay so long count as inside");
    v("radius", radius, 2.0, 1e6, "1", "beyond it a point has escaped");
    v("centre_x", centre_x, -4.0, 4.0, "1", "middle of the window, real part");
    v("centre_y", centre_y, -4.0, 4.0, "1", "middle of the window, imaginary part");
    v("extent", extent, 1e-12, 16.0, "1", "side of the window");
  }
  std::unique_ptr<ScalarField> field(bool julia, glm::dvec2 c) const {
    const double half = 0.5 * extent;
    return std::make_unique<EscapeField>(
        julia, c, EscapeOptions{iterations, radius},
        Window{{centre_x - half, centre_y - half, -half}, {centre_x + half, centre_y + half, half}});
  }
};

struct Mandelbrot : EscapeParameters {
  static constexpr const char *name = "mandelbrot",
                              *summary = "how soon points of the plane escape under z^2 + c, c the point";
  static constexpr int dimension = 2;
  Mandelbrot() { centre_x = -0.7; }
  template <typename V>
  void parameters(V&& v) {
    shared(v);
  }
  std::unique_ptr<ScalarField> make(std::uint64_t) const { return field(false, {}); }
};

struct Julia : EscapeParameters {
  static constexpr const char *name = "julia",
                              *summary = "how soon points of the plane escape under z^2 + c, z the point";
  static constexpr int dimension = 2;
  double c_x = -0.8, c_y = 0.156;
  template <typename V>
  void parameters(V&& v) {
    v("c_x", c_x, -2.0, 2.0, "1", "real part of c");
    v("c_y", c_y, -2.0, 2.0, "1", "imaginary part of c");
    shared(v);
  }
  std::unique_ptr<ScalarField> make(std::uint64_t) const { return field(true, {c_x, c_y}); }
};

}  // namespace

void add_escape_time(PrimitiveCatalogue& catalogue) {
  catalogue.add(primitive_entry<Mandelbrot>());
  catalogue.add(primitive_entry<Julia>());
}

}  // namespace verdigris
