#include "corrosion_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ground.hpp"
#include "picture.hpp"
#include "verdigris/io/write_png.hpp"
#include "verdigris/picture/patina.hpp"
#include "verdigris/picture/relief.hpp"

#ifdef VERDIGRIS_WITH_GL
#include "verdigris/gl/renderer.hpp"
#endif

using namespace verdigris;

void check_patina(const Material& material) {
  static_cast<void>(looks_of(material));
}

#ifdef VERDIGRIS_WITH_GL

struct PatinaPainter::State {
  const CorrosionGrowth& growth;
  const Material& material;
  const Scene& scene;
  Field<std::int32_t> arrivals;
  PatinaGround ground;
  LayerStack looks;
  Camera camera;
  std::optional<ReliefMaker> relief;
  std::optional<SurfaceRenderer> renderer;

  State(const CorrosionGrowth& g, const Material& m, const Scene& s)
      : growth(g), material(m), scene(s), arrivals(g.field("arrival")), looks(looks_of(m)) {
    check_picture(scene.picture);
    const Surface& surface = g.surface();
    ground = make_ground(surface, scene.seed, scene.corrosion.occlusion);
    ViewSettings view;
    view.up = scene.picture.up == "z" ? UpAxis::z : UpAxis::y;
    view.width = scene.picture.width;
    view.height = scene.picture.height;
    camera = frame_mesh(surface.mesh(), scene.picture.view, view);
    if (stands_out()) relief.emplace(surface);
    RenderOptions options;
    options.relief = relief.has_value();
    renderer.emplace(surface, options);
  }

  PatinaAges ages(double years) const {
    return {arrivals, growth.rates(), exposure_class_named(scene.corrosion.exposure),
            scene.corrosion.step_years, years};
  }

  // Model units.
  std::vector<float> heights(double years) const {
    std::vector<float> heights = patina_heights(material, ages(years));
    const auto scale = static_cast<float>(scene.corrosion.exaggerate * 1e-3 / scene.corrosion.unit_mm);
    for (float& height : heights) height *= scale;
    return heights;
  }

  // A relief of a fiftieth of a cell is not seen, and costs as much as one that is.
  bool stands_out() const {
    if (scene.corrosion.exaggerate <= 0.0) return false;
    const double now = static_cast<double>(growth.steps()) * scene.corrosion.step_years;
    float most = 0.0f;
    for (const double share : {0.25, 0.5, 1.0})
      for (const float height : heights(share * now)) most = std::max(most, std::abs(height));
    return most > 0.02 * growth.surface().cell_size();
  }
};

PatinaPainter::PatinaPainter(const CorrosionGrowth& growth, const Material& material, const Scene& scene)
    : state_(std::make_unique<State>(growth, material, scene)) {}

void PatinaPainter::draw(double years, const std::filesystem::path& file) {
  State& s = *state_;
  const std::vector<LayerCell> cells = patina_cells(s.material, s.ages(years), s.ground);
  LayerPicture picture{cells, s.looks};
  picture.holes = s.scene.corrosion.holes;
  Relief relief;
  if (s.relief) {
    relief = (*s.relief)(s.heights(years));
    picture.relief = &relief;
  }
  write_png(s.renderer->draw(picture, s.camera), file);
}

#else

struct PatinaPainter::State {};
PatinaPainter::PatinaPainter(const CorrosionGrowth&, const Material&, const Scene& scene) {
  check_picture(scene.picture);
}
void PatinaPainter::draw(double, const std::filesystem::path&) {}

#endif

PatinaPainter::~PatinaPainter() = default;
