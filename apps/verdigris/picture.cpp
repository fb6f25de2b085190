#include "picture.hpp"

#include <algorithm>

#include <glm/vec4.hpp>
#include <type_traits>

#include "verdigris/base/error.hpp"
#include "verdigris/io/write_png.hpp"
#include "verdigris/picture/palette.hpp"
#include "verdigris/picture/regions.hpp"
#include "verdigris/surface/flat_torus.hpp"
#include "verdigris/surface/owned_cells.hpp"

#ifdef VERDIGRIS_WITH_GL
#include "verdigris/gl/renderer.hpp"
#endif

using namespace verdigris;

namespace {

template <typename T>
std::vector<Rgba8> scalar_colours(const Field<T>& values, const CellColours& of) {
  std::vector<Rgba8> colours(values.size());
  const double span = of.high > of.low ? of.high - of.low : 1.0;
  std::transform(values.begin(), values.end(), colours.begin(), [&](T v) {
    return scalar_colour(static_cast<float>((static_cast<double>(v) - of.low) / span));
  });
  return colours;
}

std::vector<Rgba8> slot_colours(const Surface& surface, const CellValues& values, const CellColours& colours,
                                bool outline) {
  if (!colours.regions.empty())
    return colour_labels(surface, std::get<Field<std::int32_t>>(values), colours.regions,
                         LabelStyle{.outlines = outline});
  return std::visit([&](const auto& field) { return scalar_colours(field, colours); }, values);
}

}  // namespace

CellColours colours_for(const Surface& surface, const CellValues& values, bool labels) {
  CellColours colours;
  if (labels) {
    colours.regions = label_colours(surface, std::get<Field<std::int32_t>>(values));
    return colours;
  }
  std::visit(
      [&](const auto& field) {
        using T = typename std::decay_t<decltype(field)>::value_type;
        if (std::is_integral_v<T>) colours.high = 1.0;
        each_owned(surface, [&](std::uint32_t slot) {
          colours.low = std::min(colours.low, static_cast<double>(field[slot]));
          colours.high = std::max(colours.high, static_cast<double>(field[slot]));
        });
      },
      values);
  return colours;
}

void write_torus_picture(const std::filesystem::path& file, const Surface& surface, const CellValues& values,
                         bool labels, const TorusPlan& torus) {
  constexpr std::uint32_t good = 1024, most = 4096;
  const std::uint32_t larger = std::max(torus.width, torus.height);
  const std::uint32_t up = std::max(1u, good / larger), down = (larger + most - 1) / most;
  const std::vector<Rgba8> colours =
      slot_colours(surface, values, colours_for(surface, values, labels), false);
  const std::uint32_t across = (torus.width + down - 1) / down, high = (torus.height + down - 1) / down;
  std::vector<glm::vec4> sums(std::size_t{across} * high, glm::vec4(0.0f));
  for (std::uint32_t r = 0; r < surface.rows().size(); ++r)
    for (std::uint32_t slot = surface.owned(r).begin; slot < surface.owned(r).end; ++slot) {
      const TorusCell cell = torus_cell(surface, slot, torus.width, torus.height);
      // The first row of an image is the highest.
      const std::uint32_t row = (torus.height - 1 - cell.y) / down;
      sums[std::size_t{row} * across + cell.x / down] += glm::vec4(to_linear(colours[slot]), 1.0f);
    }
  Image image{static_cast<int>(across * up), static_cast<int>(high * up), {}};
  image.rgba.reserve(sums.size() * up * up * 4);
  for (std::uint32_t y = 0; y < high * up; ++y)
    for (std::uint32_t x = 0; x < across * up; ++x) {
      const glm::vec4 sum = sums[std::size_t{y / up} * across + x / up];
      const Rgba8 colour = from_linear(glm::vec3(sum) / sum.w);
      image.rgba.insert(image.rgba.end(), {colour.r, colour.g, colour.b, colour.a});
    }
  write_png(image, file);
}

UpAxis up_axis(const PicturePlan& plan) {
  return plan.up == "z" ? UpAxis::z : UpAxis::y;
}

ViewSettings view_settings(const PicturePlan& plan) {
  ViewSettings settings;
  settings.up = up_axis(plan);
  settings.width = plan.width;
  settings.height = plan.height;
  return settings;
}

Camera camera_of(const Mesh& mesh, const PicturePlan& plan) {
  return frame_mesh(mesh, plan.view, view_settings(plan));
}

#ifdef VERDIGRIS_WITH_GL

void check_picture(const PicturePlan& plan) {
  if (plan.up != "y" && plan.up != "z")
    throw InputError("up", "'" + plan.up + "' is no up axis", "choose y or z");
  view_direction(plan.view, up_axis(plan));
}

struct CellPainter::State {
  const Surface& surface;
  bool outline;
  SurfaceRenderer renderer;
};

CellPainter::CellPainter(const Surface& surface, bool outline, bool one_picture) {
  RenderOptions options;
  if (one_picture) options.cache_bytes = 0;  // no geometry is kept for a next one
  state_ = std::make_unique<State>(State{surface, outline, SurfaceRenderer(surface, options)});
}

Image CellPainter::draw(const CellValues& values, const CellColours& colours, const Camera& camera) {
  return state_->renderer.draw(slot_colours(state_->surface, values, colours, state_->outline), camera);
}

#else

struct CellPainter::State {};

CellPainter::CellPainter(const Surface&, bool, bool) {
  check_picture({});
}

Image CellPainter::draw(const CellValues&, const CellColours&, const Camera&) {
  return {};
}

void check_picture(const PicturePlan&) {
  throw InputError("picture", "this build has no OpenGL", "use --no-picture, or build with VERDIGRIS_GL=ON");
}

#endif

CellPainter::~CellPainter() = default;

void write_picture(const std::filesystem::path& file, const Surface& surface, const CellValues& values,
                   bool labels, const PicturePlan& plan) {
  check_picture(plan);
  CellPainter painter(surface, plan.outline, true);
  write_png(painter.draw(values, colours_for(surface, values, labels), camera_of(surface.mesh(), plan)),
            file);
}
