#include "picture.hpp"

#include <algorithm>

#include <glm/vec4.hpp>
#include <type_traits>

#include "verdigris/base/error.hpp"
#include "verdigris/io/write_png.hpp"
#include "verdigris/picture/palette.hpp"
#include "verdigris/picture/regions.hpp"
#include "verdigris/surface/flat_torus.hpp"

#ifdef VERDIGRIS_WITH_GL
#include "verdigris/gl/renderer.hpp"
#endif

using namespace verdigris;

namespace {

template <typename T>
std::vector<Rgba8> scalar_colours(const Field<T>& values, const ColourScale& range) {
  std::vector<Rgba8> colours(values.size());
  const double span = range.high > range.low ? range.high - range.low : 1.0;
  std::transform(values.begin(), values.end(), colours.begin(), [&](T v) {
    return scalar_colour(static_cast<float>((static_cast<double>(v) - range.low) / span));
  });
  return colours;
}

std::vector<Rgba8> colours_of(const Surface& surface, const CellValues& values, bool labels, bool outline,
                              const ColourScale& range) {
  if (labels) {
    const auto& label = std::get<Field<std::int32_t>>(values);
    return colour_labels(surface, label, label_colours(surface, label), LabelStyle{.outlines = outline});
  }
  return std::visit([&](const auto& field) { return scalar_colours(field, range); }, values);
}

}  // namespace

ColourScale scale_over(const Surface& surface, const CellValues& values) {
  return std::visit(
      [&](const auto& field) {
        using T = typename std::decay_t<decltype(field)>::value_type;
        ColourScale range{0.0, std::is_integral_v<T> ? 1.0 : 0.0};
        for (std::uint32_t r = 0; r < surface.rows().size(); ++r) {
          const SlotRun run = surface.owned(r);
          for (std::uint32_t slot = run.begin; slot < run.end; ++slot) {
            range.low = std::min(range.low, static_cast<double>(field[slot]));
            range.high = std::max(range.high, static_cast<double>(field[slot]));
          }
        }
        return range;
      },
      values);
}

void write_torus_picture(const std::filesystem::path& file, const Surface& surface, const CellValues& values,
                         bool labels, const TorusPlan& torus) {
  constexpr std::uint32_t good = 1024, most = 4096;
  const std::uint32_t larger = std::max(torus.width, torus.height);
  const std::uint32_t up = std::max(1u, good / larger), down = (larger + most - 1) / most;
  const std::vector<Rgba8> colours = colours_of(surface, values, labels, false, scale_over(surface, values));
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

ViewSettings view_settings(const PicturePlan& plan) {
  ViewSettings settings;
  settings.up = plan.up == "z" ? UpAxis::z : UpAxis::y;
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
  view_direction(plan.view, plan.up == "z" ? UpAxis::z : UpAxis::y);
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

Image CellPainter::draw(const CellValues& values, bool labels, const ColourScale& range,
                        const Camera& camera) {
  return state_->renderer.draw(colours_of(state_->surface, values, labels, state_->outline, range), camera);
}

#else

struct CellPainter::State {};

CellPainter::CellPainter(const Surface&, bool, bool) {
  check_picture({});
}

Image CellPainter::draw(const CellValues&, bool, const ColourScale&, const Camera&) {
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
  write_png(painter.draw(values, labels, scale_over(surface, values), camera_of(surface.mesh(), plan)), file);
}
