#pragma once
// Pictures of a weathering surface, one after each operation.

#include <filesystem>
#include <memory>

#include "verdigris/io/scene.hpp"
#include "verdigris/surface/surface.hpp"

/// What does not change between pictures is made once. Throws InputError where there is no OpenGL.
class WeatherPainter {
 public:
  /// Both must outlive it.
  WeatherPainter(const verdigris::Surface& surface, const verdigris::Scene& scene);
  ~WeatherPainter();
  WeatherPainter(const WeatherPainter&) = delete;
  WeatherPainter& operator=(const WeatherPainter&) = delete;

  void draw(const verdigris::CoatedMetal& metal, const std::filesystem::path& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};
