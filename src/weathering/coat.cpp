// Coats: paint, glaze, varnish, thicker here and thinner there as a brush leaves them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "cells.hpp"
#include "entries.hpp"
#include "hex_colour.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/lie.hpp"
#include "verdigris/exposure/surface_field.hpp"
#include "verdigris/synthesis/fractal_noise.hpp"

namespace verdigris::weathering {

namespace {

// A field drawn out along one axis: what bristles do to noise.
class Drawn final : public ScalarField {
 public:
  Drawn(std::unique_ptr<ScalarField> field, glm::dvec3 along, double stretch)
      : field_(std::move(field)), along_(glm::normalize(along)), shrink_(1.0 - 1.0 / stretch) {}
  ValueRange range() const override { return field_->range(); }

 private:
  void compute(const Points& points, double footprint, std::span<float> out) const override {
    std::array<std::vector<double>, 3> p;
    for (auto& axis : p) axis.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const glm::dvec3 at(points.x[k], points.y.empty() ? 0.0 : points.y[k],
                          points.z.empty() ? 0.0 : points.z[k]);
      const glm::dvec3 moved = at - shrink_ * glm::dot(at, along_) * along_;
      for (int axis = 0; axis < 3; ++axis) p[static_cast<std::size_t>(axis)][k] = moved[axis];
    }
    field_->evaluate({p[0], p[1], p[2], {}}, footprint, out);
  }

  std::unique_ptr<ScalarField> field_;
  glm::dvec3 along_;
  double shrink_;
};

struct CoatOperator {
  static constexpr const char *name = "coat", *summary = "lays a coat of paint, glaze or varnish on top";
  static std::vector<std::string> masks() { return {"where"}; }

  std::string layer = "paint", colour = "#808080", along;
  double thickness = 60.0, variation = 0.15, strokes = 40.0;
  double roughness = 0.4, opacity = 0.8, unit = 10.0, density = 1.4;

  template <typename V>
  void parameters(V&& v) {
    v("layer", layer, {}, "its name");
    v("colour", colour, {}, "\"#rrggbb\"");
    v("thickness", thickness, 0.0, 1e5, "um", "mean thickness where the mask is 1");
    v("variation", variation, 0.0, 1.0, "1", "how uneven it is, relative to the thickness");
    v("strokes", strokes, 1.0, 1e5, "1", "brush strokes over the model's longest side");
    v("along", along, {}, "direction of the strokes, as \"y\" or \"1 0 1\"; empty: none, as sprayed");
    v("roughness", roughness, 0.0, 1.0, "1", "0 mirror to 1 matt");
    v("opacity", opacity, 0.0, 0.999, "1", "how little light passes");
    v("unit", unit, 1e-6, 1e6, "um", "thickness that counts as 1 for the light");
    v("density", density, 1e-3, 100.0, "g/cm3", "of the dry coat");
  }

  void check() const {
    if (layer.empty()) throw InputError("coat", "it has no name", "write layer = \"paint\"");
    colour_of(colour, "coat");
    if (!along.empty()) parse_direction(along, "coat: along");
  }

  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    check();
    for (const Coat& other : metal.coats)
      if (other.layer.name == layer)
        throw InputError("coat", fmt::format("there is a coat '{}' already", layer), "give it another name");
    Coat coat;
    coat.layer.name = layer;
    coat.layer.finish.colour = colour_of(colour, "coat");
    coat.layer.finish.roughness = static_cast<float>(roughness);
    coat.layer.finish.specular = static_cast<float>(0.5 * (1.0 - roughness));
    coat.layer.finish.shininess = static_cast<float>(4.0 + 60.0 * (1.0 - roughness) * (1.0 - roughness));
    coat.layer.opacity = opacity;
    coat.layer.unit = unit;
    coat.layer.density = density;
    coat.thickness = relative_thickness(setup);
    const Field<float>* where = setup.mask("where");
    // The noise shares out what there is: its mean is 1 to rounding.
    double sum = 0.0;
    each_owned(setup.surface, [&](std::uint32_t slot) { sum += static_cast<double>(coat.thickness[slot]); });
    const double scale = thickness * static_cast<double>(setup.surface.owned_count()) / std::max(sum, 1e-30);
    for_owned(setup.surface, [&](std::uint32_t slot) {
      coat.thickness[slot] = static_cast<float>(static_cast<double>(coat.thickness[slot]) * scale *
                                                OperatorSetup::at(where, slot));
    });
    OperatorReport report;
    each_owned(setup.surface, [&](std::uint32_t slot) {
      report.added += static_cast<double>(coat.thickness[slot]);
      report.cells += coat.thickness[slot] > 0.0f;
    });
    metal.coats.push_back(std::move(coat));
    return report;
  }

  // [slot] 1 and the noise.
  Field<float> relative_thickness(const OperatorSetup& setup) const {
    Field<float> values(setup.surface.slot_count(), 1.0f);
    if (variation <= 0.0) return values;
    Fbm fbm;
    fbm.lattice.frequency = along.empty() ? strokes : 0.5 * strokes;
    fbm.series.octaves = 4;
    fbm.series.H = 0.7;
    auto noise = fbm.make(setup.seed);
    if (!along.empty())
      noise = std::make_unique<Drawn>(std::move(noise), parse_direction(along, "coat: along"), 12.0);
    const Field<float> raw = field_on_surface(setup.surface, *noise);
    for_owned(setup.surface, [&](std::uint32_t slot) {
      values[slot] = std::max(0.0f, 1.0f + static_cast<float>(2.0 * variation) * raw[slot]);
    });
    return values;
  }
};

}  // namespace

void add_coat(OperatorCatalogue& catalogue) {
  catalogue.add<CoatOperator>();
}

}  // namespace verdigris::weathering
