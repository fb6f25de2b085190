#include "weather_pictures.hpp"

#include <optional>

#include "ground.hpp"
#include "picture.hpp"
#include "verdigris/io/write_png.hpp"
#include "verdigris/picture/coat_picture.hpp"

#ifdef VERDIGRIS_WITH_GL
#include "verdigris/gl/renderer.hpp"
#endif

using namespace verdigris;

#ifdef VERDIGRIS_WITH_GL

struct WeatherPainter::State {
  const Scene& scene;
  PatinaGround ground;
  Camera camera;
  std::optional<ReliefMaker> relief;
  SurfaceRenderer renderer;

  static RenderOptions options_for(const Scene& scene) {
    RenderOptions options;
    options.relief = scene.weathering.exaggerate > 0.0;
    return options;
  }
  State(const Surface& surface, const Scene& s)
      : scene(s),
        ground(make_ground(surface, s.seed, s.weathering.occlusion)),
        renderer(surface, options_for(s)) {
    ViewSettings view;
    view.up = s.picture.up == "z" ? UpAxis::z : UpAxis::y;
    view.width = s.picture.width;
    view.height = s.picture.height;
    camera = frame_mesh(surface.mesh(), s.picture.view, view);
    if (s.weathering.exaggerate > 0.0) relief.emplace(surface);
  }
};

WeatherPainter::WeatherPainter(const Surface& surface, const Scene& scene)
    : state_(std::make_unique<State>(surface, scene)) {}

void WeatherPainter::draw(const CoatedMetal& metal, const std::filesystem::path& file) {
  State& s = *state_;
  const CoatPicture coats = picture_of(metal, s.ground.tints, s.ground.open);
  LayerPicture picture{coats.cells, coats.stack};
  Relief relief;
  if (s.relief) {
    std::vector<float> heights = coat_heights(metal);
    const auto scale = static_cast<float>(s.scene.weathering.exaggerate * 1e-3 / s.scene.weathering.unit_mm);
    for (float& height : heights) height *= scale;
    relief = (*s.relief)(std::move(heights));
    picture.relief = &relief;
  }
  write_png(s.renderer.draw(picture, s.camera), file);
}

#else

struct WeatherPainter::State {};
WeatherPainter::WeatherPainter(const Surface&, const Scene& scene) {
  check_picture(scene.picture);
}
void WeatherPainter::draw(const CoatedMetal&, const std::filesystem::path&) {}

#endif

WeatherPainter::~WeatherPainter() = default;
