#pragma once
// Pictures of corroding metal at any age.

#include <filesystem>
#include <memory>

#include "verdigris/behaviours/corrosion_growth.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/material/material.hpp"

/// Draws one run of corrosion; what does not change with age is made once. Throws InputError where there is
/// no OpenGL, and for a material of more layers than pictures hold.
class PatinaPainter {
 public:
  /// All must outlive it.
  PatinaPainter(const verdigris::CorrosionGrowth& growth, const verdigris::Material& material,
                const verdigris::Scene& scene);
  ~PatinaPainter();
  PatinaPainter(const PatinaPainter&) = delete;
  PatinaPainter& operator=(const PatinaPainter&) = delete;

  /// The model after so many years, at most those grown, as a PNG.
  void draw(double years, const std::filesystem::path& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws InputError for a material that cannot be drawn: known before a long run rather than after.
void check_patina(const verdigris::Material& material);
