#include "layer_painter.hpp"

#include <algorithm>
#include <cmath>
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
  float least_height;

  static RenderOptions options_for(bool relief) {
    RenderOptions options;
    options.relief = relief;
    return options;
  }
  State(const Surface& surface, bool with_relief)
      : renderer(surface, options_for(with_relief)),
        least_height(static_cast<float>(0.02 * surface.cell_size())) {
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
  // A relief of a fiftieth of a cell is not seen, and costs as much as one that is.
  const auto seen = [&](float height) { return std::abs(height) > state_->least_height; };
  if (state_->relief && std::any_of(heights.begin(), heights.end(), seen)) {
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
