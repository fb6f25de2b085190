#pragma once
// Pictures of a weathering surface.

#include "layer_painter.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/weathering/coated_metal.hpp"

/// Draws the states of one surface. Throws InputError where there is no OpenGL.
class WeatherPainter {
 public:
  /// Both must outlive it.
  WeatherPainter(const verdigris::Surface& surface, const verdigris::Scene& scene);

  verdigris::Image draw(const verdigris::CoatedMetal& metal, const verdigris::Camera& camera);

 private:
  const verdigris::Surface& surface_;
  const verdigris::Scene& scene_;
  LayerPainter painter_;
};
