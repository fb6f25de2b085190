#include "weather_pictures.hpp"

#include <utility>
#include <vector>

#include "verdigris/picture/coat_picture.hpp"

using namespace verdigris;

WeatherPainter::WeatherPainter(const Surface& surface, const Scene& scene)
    : surface_(surface),
      scene_(scene),
      painter_(surface, scene.seed, scene.weathering.occlusion, scene.weathering.exaggerate > 0.0) {}

Image WeatherPainter::draw(const CoatedMetal& metal, const Camera& camera) {
  const CoatPicture coats = picture_of(surface_, metal, painter_.ground().tints, painter_.ground().open);
  std::vector<float> heights;
  if (scene_.weathering.exaggerate > 0.0) {
    heights = coat_heights(surface_, metal);
    const auto scale = static_cast<float>(scene_.weathering.exaggerate * 1e-3 / scene_.weathering.unit_mm);
    for (float& height : heights) height *= scale;
  }
  return painter_.draw(coats.cells, coats.stack, std::move(heights), false, camera);
}
