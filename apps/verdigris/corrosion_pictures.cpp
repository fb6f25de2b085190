#include "corrosion_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "verdigris/picture/patina.hpp"

using namespace verdigris;

void check_patina(const Material& material) {
  static_cast<void>(looks_of(material));
}

PatinaPainter::PatinaPainter(const CorrosionGrowth& growth, const Material& material, const Scene& scene)
    : growth_(growth),
      material_(material),
      scene_(scene),
      arrivals_(growth.field("arrival")),
      looks_(looks_of(material)),
      relief_(stands_out()),
      painter_(growth.surface(), scene.seed, scene.corrosion.occlusion, relief_) {}

PatinaAges PatinaPainter::ages(double years) const {
  return {arrivals_, growth_.rates(), exposure_class_named(scene_.corrosion.exposure),
          scene_.corrosion.step_years, years};
}

// Model units.
std::vector<float> PatinaPainter::heights(double years) const {
  std::vector<float> heights = patina_heights(material_, ages(years));
  const auto scale = static_cast<float>(scene_.corrosion.exaggerate * 1e-3 / scene_.corrosion.unit_mm);
  for (float& height : heights) height *= scale;
  return heights;
}

// A relief of a fiftieth of a cell is not seen, and costs as much as one that is.
bool PatinaPainter::stands_out() const {
  if (scene_.corrosion.exaggerate <= 0.0) return false;
  const double now = static_cast<double>(growth_.steps()) * scene_.corrosion.step_years;
  float most = 0.0f;
  for (const double share : {0.25, 0.5, 1.0})
    for (const float height : heights(share * now)) most = std::max(most, std::abs(height));
  return most > 0.02 * growth_.surface().cell_size();
}

Image PatinaPainter::draw(double years, const Camera& camera) {
  const std::vector<LayerCell> cells = patina_cells(material_, ages(years), painter_.ground());
  return painter_.draw(cells, looks_, relief_ ? heights(years) : std::vector<float>{}, scene_.corrosion.holes,
                       camera);
}
