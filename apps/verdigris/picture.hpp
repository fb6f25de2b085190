#pragma once
// The picture of a run.

#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/picture/camera.hpp"
#include "verdigris/picture/colour.hpp"
#include "verdigris/picture/image.hpp"
#include "verdigris/surface/surface.hpp"

/// Whole or real numbers, [slot].
using CellValues = std::variant<verdigris::Field<std::int32_t>, verdigris::Field<float>>;

/// The colours of a field's values.
struct CellColours {
  std::vector<verdigris::Rgba8> regions;  ///< [label] of a field of labels; empty for any other
  double low = 0.0, high = 0.0;           ///< values that get the first and the last colour of the map
};

/// Colours that tell touching regions apart, or a map from the least to the greatest value, 0 among them; of
/// whole numbers 1 too.
CellColours colours_for(const verdigris::Surface& surface, const CellValues& values, bool labels);

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

  verdigris::Image draw(const CellValues& values, const CellColours& colours,
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

/// The axis that points up.
verdigris::UpAxis up_axis(const verdigris::PicturePlan& plan);

/// Size and up axis of a plan.
verdigris::ViewSettings view_settings(const verdigris::PicturePlan& plan);

/// The camera of a plan. Throws InputError.
verdigris::Camera camera_of(const verdigris::Mesh& mesh, const verdigris::PicturePlan& plan);

/// Throws InputError when write_picture could not draw `plan`: known before a long run rather than after.
void check_picture(const verdigris::PicturePlan& plan);
