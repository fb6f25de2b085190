#pragma once
// The picture of a run.

#include <filesystem>
#include <memory>
#include <variant>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/picture/camera.hpp"
#include "verdigris/picture/image.hpp"
#include "verdigris/surface/surface.hpp"

/// Whole or real numbers, [slot].
using CellValues = std::variant<verdigris::Field<std::int32_t>, verdigris::Field<float>>;

/// Values that get the first and the last colour of the map.
struct ColourScale {
  double low = 0.0, high = 0.0;
};
/// Least and greatest, 0 among them; of whole numbers 1 too.
ColourScale scale_over(const verdigris::Surface& surface, const CellValues& values);

/// Draws cells of one surface: labels as regions, any other field by a colour map. Throws InputError where
/// there is no OpenGL.
class CellPainter {
 public:
  /// The surface must outlive it. `outline`: dark lines between regions; `one_picture`: keep no geometry for
  /// a next one.
  explicit CellPainter(const verdigris::Surface& surface, bool outline, bool one_picture = false);
  ~CellPainter();
  CellPainter(const CellPainter&) = delete;
  CellPainter& operator=(const CellPainter&) = delete;

  /// `range` does not count for labels.
  verdigris::Image draw(const CellValues& values, bool labels, const ColourScale& range,
                        const verdigris::Camera& camera);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Draws labels as regions, any other field by a colour map, and writes a PNG. Throws InputError where there
/// is no OpenGL.
void write_picture(const std::filesystem::path& file, const verdigris::Surface& surface,
                   const CellValues& values, bool labels, const verdigris::PicturePlan& plan);

/// The same of a flat torus: an image of its cells from above, each a square of whole pixels or, where there
/// are too many, the mean of some. Needs no OpenGL.
void write_torus_picture(const std::filesystem::path& file, const verdigris::Surface& surface,
                         const CellValues& values, bool labels, const verdigris::TorusPlan& torus);

/// Size, up axis and margins of a plan.
verdigris::ViewSettings view_settings(const verdigris::PicturePlan& plan);

/// The camera of a plan. Throws InputError.
verdigris::Camera camera_of(const verdigris::Mesh& mesh, const verdigris::PicturePlan& plan);

/// Throws InputError when write_picture could not draw `plan`: known before a long run rather than after.
void check_picture(const verdigris::PicturePlan& plan);
