#pragma once
// Pictures of a surface, drawn off screen.

#include <memory>
#include <span>
#include <string>

#include "verdigris/picture/bands.hpp"
#include "verdigris/picture/camera.hpp"
#include "verdigris/picture/image.hpp"
#include "verdigris/picture/layers.hpp"
#include "verdigris/picture/light.hpp"
#include "verdigris/picture/relief.hpp"

namespace verdigris {

/// How a picture looks apart from the colours of the cells.
struct RenderOptions {
  LightSettings light;
  double crease_angle = 40.0;  ///< degrees, see corner_normals
  int samples = 4;             ///< per pixel, 1..16; limited to what the driver has
  int supersampling = 1;       ///< 2 draws at twice the size and averages: finer, four times the work
  Rgba8 background_top{250, 249, 246, 255}, background_bottom{229, 227, 221, 255};  ///< alpha 0: transparent
  std::size_t chunk_slots = 1u << 16;  ///< slots drawn at once: memory grows with it, not with the surface
  std::size_t cache_bytes = std::size_t{768}
                            << 20;  ///< geometry kept for the next picture, see SurfaceRenderer
  bool relief = false;              ///< pictures may have one: geometry is made ready to be moved
};

/// Layers over a substrate, to be drawn.
struct LayerPicture {
  std::span<const LayerCell> cells;  ///< [slot], ghosts included
  const LayerStack& stack;
  StudioSettings studio = {};
  const Relief* relief = nullptr;  ///< needs RenderOptions::relief
  bool holes = false;              ///< absent metal is not drawn; else LayerStack::gone stands there
};

/// Draws pictures of one surface, any number of them with other colours and cameras.
///
/// Light is computed in linear space: slot colours are sRGB, decoded before they are interpolated and lit;
/// samples are averaged in linear light and encoded last. Faces seen from behind are lit on that side. Bands
/// are built and drawn chunk by chunk. Those that fit into `cache_bytes` are kept: the next picture then
/// costs only its colours. Not for use by two threads at once; belongs to the thread that made it. Throws
/// InputError where there is no OpenGL, or when the image is larger than the driver can draw.
class SurfaceRenderer {
 public:
  explicit SurfaceRenderer(const Surface& surface, const RenderOptions& options = {});
  ~SurfaceRenderer();
  SurfaceRenderer(SurfaceRenderer&&) noexcept;
  SurfaceRenderer& operator=(SurfaceRenderer&&) noexcept;

  /// `slot_colours` has one colour a slot, ghosts included; cells of alpha 0 are not drawn (holes), there is
  /// no half transparency.
  Image draw(std::span<const Rgba8> slot_colours, const Camera& camera);

  /// The same of layers: each is lit where it is seen, then they are mixed (picture/layers.hpp says how, and
  /// gives the same on the CPU to 1/255). Of RenderOptions::light only the sources count, the coefficients
  /// are those of the layers. Depths are interpolated between cells.
  Image draw(const LayerPicture& picture, const Camera& camera);

  /// The driver's name for itself, for reports.
  std::string driver() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One picture: SurfaceRenderer(surface, options).draw(slot_colours, camera).
Image render(const Surface& surface, std::span<const Rgba8> slot_colours, const Camera& camera,
             const RenderOptions& options = {});

}  // namespace verdigris
