#include "verdigris/synthesis/domain_warp.hpp"

#include <utility>

#include "octaves.hpp"
#include "sampled_values.hpp"

namespace verdigris {

namespace {

using namespace synthesis;

// Each axis is displaced by an fbm of its own; `displaced` is evaluated there.
class Warped final : public ScalarField {
 public:
  Warped(std::vector<std::unique_ptr<ScalarField>> displacement, std::unique_ptr<ScalarField> displaced,
         double strength, double cell)
      : displacement_(std::move(displacement)),
        displaced_(std::move(displaced)),
        strength_(strength),
        cell_(cell) {}
  ValueRange range() const override { return sampled_range(*this, cell_); }

 private:
  void compute(const Points& points, double footprint, std::span<float> out) const override {
    // Where the warp stretches space by s, neighbouring samples lie s footprints apart in it. The deviation
    // of the displacement's slope is about that of noise, 1 a cell of its coarsest octave.
    const double stretched = footprint * (1.0 + strength_ / cell_);
    for_blocks(points, out, [&](const PointBlock& block, float* value) {
      const auto span = [&](std::size_t a) { return std::span<const double>(block.axis[a], lanes); };
      const Points here{span(0), span(1), span(2), span(3)};
      double there[4][lanes];
      float by[lanes];
      for (std::size_t a = 0; a < 4; ++a) {
        if (a >= displacement_.size()) {
          std::copy_n(block.axis[a], lanes, there[a]);
          continue;
        }
        displacement_[a]->evaluate(here, footprint, by);
        for (std::size_t k = 0; k < lanes; ++k)
          there[a][k] = block.axis[a][k] + strength_ * static_cast<double>(by[k]);
      }
      displaced_->evaluate({there[0], there[1], there[2], there[3]}, stretched, {value, lanes});
    });
  }

  std::vector<std::unique_ptr<ScalarField>> displacement_;
  std::unique_ptr<ScalarField> displaced_;
  double strength_, cell_;
};

}  // namespace

std::unique_ptr<ScalarField> DomainWarp::make(std::uint64_t seed) const {
  std::vector<std::unique_ptr<ScalarField>> displacement;
  OctaveSeries coarse = series;
  coarse.octaves = warp_octaves;
  for (int a = 0; a < lattice.dimensions; ++a)
    displacement.push_back(
        Fbm{lattice, coarse}.make(seed ^ (0x9e3779b97f4a7c15u * (static_cast<std::uint64_t>(a) + 1))));
  return std::make_unique<Warped>(std::move(displacement), Fbm{lattice, series}.make(seed), strength,
                                  1.0 / lattice.frequency);
}

}  // namespace verdigris
