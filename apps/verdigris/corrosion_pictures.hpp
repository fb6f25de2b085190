#pragma once
// Pictures of corroding metal at any age.

#include "layer_painter.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/material/material.hpp"

/// Draws one run of corrosion. Throws InputError where there is no OpenGL, and for a material of more layers
/// than pictures hold.
class PatinaPainter {
 public:
  /// All must outlive it.
  PatinaPainter(const verdigris::CorrosionGrowth& growth, const verdigris::Material& material,
                const verdigris::Scene& scene);

  /// The model after so many years, at most those grown.
  verdigris::Image draw(double years, const verdigris::Camera& camera);

 private:
  verdigris::PatinaAges ages(double years) const;
  std::vector<float> heights(double years) const;
  bool stands_out() const;

  const verdigris::CorrosionGrowth& growth_;
  const verdigris::Material& material_;
  const verdigris::Scene& scene_;
  verdigris::Field<std::int32_t> arrivals_;
  verdigris::LayerStack looks_;
  bool relief_;
  LayerPainter painter_;
};

/// Throws InputError for a material that cannot be drawn: known before a long run rather than after.
void check_patina(const verdigris::Material& material);
