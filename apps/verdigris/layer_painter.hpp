#pragma once
// Pictures of layers on one surface, any number of them.

#include <memory>
#include <span>
#include <vector>

#include "verdigris/io/scene.hpp"
#include "verdigris/picture/camera.hpp"
#include "verdigris/picture/image.hpp"
#include "verdigris/picture/layers.hpp"
#include "verdigris/picture/patina.hpp"
#include "verdigris/surface/surface.hpp"

/// What does not change between pictures is made once. Not for two threads at once; belongs to the thread
/// that made it. Throws InputError where there is no OpenGL.
class LayerPainter {
 public:
  /// The surface must outlive it. `seed` is of the blotches of the ground; `occlusion`: what sees little of
  /// its surroundings is darker; `relief`: pictures have heights.
  LayerPainter(const verdigris::Surface& surface, std::uint64_t seed, bool occlusion, bool relief);
  ~LayerPainter();
  LayerPainter(const LayerPainter&) = delete;
  LayerPainter& operator=(const LayerPainter&) = delete;

  const verdigris::PatinaGround& ground() const { return ground_; }

  /// `heights` [slot] in model units, where it was made for relief, else empty. `holes`: cells without metal
  /// are not drawn.
  verdigris::Image draw(std::span<const verdigris::LayerCell> cells, const verdigris::LayerStack& stack,
                        std::vector<float> heights, bool holes, const verdigris::Camera& camera);

 private:
  struct State;
  verdigris::PatinaGround ground_;
  std::unique_ptr<State> state_;
};
