#include "layer_painter.hpp"

#include <optional>
#include <utility>

#include "ground.hpp"
#include "picture.hpp"
#include "verdigris/picture/relief.hpp"

#ifdef VERDIGRIS_WITH_GL
#include "verdigris/gl/renderer.hpp"
#endif

using namespace verdigris;

#ifdef VERDIGRIS_WITH_GL

struct LayerPainter::State {
  std::optional<ReliefMaker> relief;
  SurfaceRenderer renderer;

  static RenderOptions options_for(bool relief) {
    RenderOptions options;
    options.relief = relief;
    return options;
  }
  State(const Surface& surface, bool with_relief) : renderer(surface, options_for(with_relief)) {
    if (with_relief) relief.emplace(surface);
  }
};

LayerPainter::LayerPainter(const Surface& surface, std::uint64_t seed, bool occlusion, bool relief)
    : ground_(make_ground(surface, seed, occlusion)), state_(std::make_unique<State>(surface, relief)) {}

Image LayerPainter::draw(std::span<const LayerCell> cells, const LayerStack& stack,
                         std::vector<float> heights, bool holes, const Camera& camera) {
  LayerPicture picture{cells, stack};
  picture.holes = holes;
  Relief relief;
  if (state_->relief && !heights.empty()) {
    relief = (*state_->relief)(std::move(heights));
    picture.relief = &relief;
  }
  return state_->renderer.draw(picture, camera);
}

#else

struct LayerPainter::State {};
LayerPainter::LayerPainter(const Surface&, std::uint64_t, bool, bool) {
  check_picture({});
}
Image LayerPainter::draw(std::span<const LayerCell>, const LayerStack&, std::vector<float>, bool,
                         const Camera&) {
  return {};
}

#endif

LayerPainter::~LayerPainter() = default;
