#include "picture.hpp"

#include <algorithm>

#include "verdigris/base/error.hpp"

#ifdef VERDIGRIS_WITH_GL
#include "verdigris/gl/renderer.hpp"
#include "verdigris/io/write_png.hpp"
#include "verdigris/picture/regions.hpp"
#endif

using namespace verdigris;

#ifdef VERDIGRIS_WITH_GL

namespace {

std::vector<Rgba8> scalar_colours(const Surface& surface, const Field<std::int32_t>& values) {
  std::int32_t low = 0, high = 1;
  for (std::uint32_t r = 0; r < surface.rows().size(); ++r) {
    const SlotRun run = surface.owned(r);
    for (std::uint32_t slot = run.begin; slot < run.end; ++slot) {
      low = std::min(low, values[slot]);
      high = std::max(high, values[slot]);
    }
  }
  std::vector<Rgba8> colours(values.size());
  const float range = static_cast<float>(high - low);
  std::transform(values.begin(), values.end(), colours.begin(),
                 [&](std::int32_t v) { return scalar_colour(static_cast<float>(v - low) / range); });
  return colours;
}

}  // namespace

void check_picture(const PicturePlan& plan) {
  if (plan.up != "y" && plan.up != "z")
    throw InputError("up", "'" + plan.up + "' is no up axis", "choose y or z");
  view_direction(plan.view, plan.up == "z" ? UpAxis::z : UpAxis::y);
}

void write_picture(const std::filesystem::path& file, const Surface& surface,
                   const Field<std::int32_t>& values, bool labels, const PicturePlan& plan) {
  check_picture(plan);
  ViewSettings settings;
  settings.up = plan.up == "z" ? UpAxis::z : UpAxis::y;
  settings.width = plan.width;
  settings.height = plan.height;
  const Camera camera = frame_mesh(surface.mesh(), plan.view, settings);
  const std::vector<Rgba8> colours = labels ? colour_labels(surface, values, label_colours(surface, values),
                                                            LabelStyle{.outlines = plan.outline})
                                            : scalar_colours(surface, values);
  RenderOptions options;
  options.cache_bytes = 0;  // one picture: no geometry is kept for a next one
  write_png(render(surface, colours, camera, options), file);
}

#else

void write_picture(const std::filesystem::path&, const Surface&, const Field<std::int32_t>&, bool,
                   const PicturePlan&) {
  check_picture({});
}

void check_picture(const PicturePlan&) {
  throw InputError("picture", "this build has no OpenGL", "use --no-picture, or build with VERDIGRIS_GL=ON");
}

#endif
