#include "corrosion_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

#include "corrosion_pictures.hpp"
#include "picture.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/corrosion_layers.hpp"
#include "verdigris/io/read_material.hpp"
#include "verdigris/io/write_cells.hpp"
#include "verdigris/io/write_corrosion.hpp"
#include "verdigris/io/write_png.hpp"
#include "verdigris/picture/plot.hpp"

using namespace verdigris;

namespace {
constexpr std::uint64_t most_rows = 2000;  // of statistics.csv, about

std::string picture_name(double years) {
  return fmt::format("patina-{:07.3f}y.png", years);
}
}  // namespace

Material prepare_corrosion(Scene& scene) {
  const CorrosionPlan& plan = scene.corrosion;
  if (scene.behaviour != "corrosion")
    throw InputError("material", fmt::format("{} does not corrode", scene.behaviour),
                     "write behaviour corrosion, or leave the material out");
  if (!(plan.step_years > 0.0))
    throw InputError("material", "the length of a step is not given",
                     "write step_years, or give --step-length");
  // A patina grows on for ever.
  if (scene.steps == 0)
    throw InputError("steps", "a material that ages in years needs to know when to end",
                     "write steps under [run]");
  const double end = static_cast<double>(scene.steps) * plan.step_years;
  std::vector<std::string> names;
  for (const double years : plan.frames) {
    if (!(years <= end * (1.0 + 1e-9)))
      throw InputError("frames",
                       fmt::format("there is no picture after {:g} years: the run ends at {:g}", years, end),
                       "give ages of the run");
    names.push_back(picture_name(years));
    if (std::count(names.begin(), names.end(), names.back()) > 1)
      throw InputError("frames", fmt::format("two pictures would be {}", names.back()),
                       "leave a thousandth of a year between ages");
  }
  Material material = find_material(plan.material);
  if (scene.picture.draw) check_patina(material);
  const ExposureClass exposure = exposure_class_named(plan.exposure);
  const LinearThickness law = with_lifetime({}, material, exposure, plan.step_years).thickness;
  const auto set = [&](const char* name, double value) {
    std::erase_if(scene.parameters, [&](const auto& pair) { return pair.first == name; });
    scene.parameters.emplace_back(name, value);
  };
  set("metal", law.metal);
  set("k1", law.k1);
  return material;
}

double guessed_unit_mm(const Mesh& mesh) {
  const Bounds bounds = mesh_bounds(mesh);
  const glm::dvec3 size = bounds.upper - bounds.lower;
  return std::max({size.x, size.y, size.z}) >= 10.0 ? 1.0 : 1000.0;
}

std::vector<CorrosionNumbers> corrosion_history(const CorrosionGrowth& growth, const Material& material,
                                                const CorrosionPlan& plan) {
  CorrosionStatistics statistics(scale_of(material, exposure_class_named(plan.exposure), plan.step_years));
  std::vector<CorrosionNumbers> numbers;
  // Each row costs as much as steps were made: of very long runs some two thousand are enough.
  const std::uint64_t last = growth.steps(), every = std::max<std::uint64_t>(1, last / 30),
                      stride = 1 + (std::max<std::uint64_t>(last, 1) - 1) / most_rows;
  std::uint64_t next_spots = 0;
  for (std::uint64_t step = 0;; step = std::min(step + stride, last)) {
    const bool with_spots = step >= next_spots || step == last;
    if (with_spots) next_spots = step / every * every + every;
    numbers.push_back(statistics.measure_at(growth, step, with_spots));
    if (step == last) break;
  }
  return numbers;
}

namespace {

std::string field_name(std::string text) {
  for (char& c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return text;
}

void write_cells(const std::filesystem::path& file, const CorrosionGrowth& growth, const Material& material,
                 const CorrosionPlan& plan, std::span<const Mask> masks) {
  const LayerFields fields =
      corrosion_layers(growth, material, exposure_class_named(plan.exposure), plan.step_years);
  const Field<std::int32_t> ages = growth.ages(), state = growth.field("state"),
                            strong = growth.field("strong");
  Field<float> years(ages.size()), metal(ages.size());
  for (std::size_t slot = 0; slot < ages.size(); ++slot) {
    years[slot] = ages[slot] < 0 ? -1.0f : static_cast<float>(ages[slot] * plan.step_years);
    metal[slot] = static_cast<float>(material.thickness) - fields.metal_lost[slot];
  }
  std::vector<CellArray> arrays{{"state", &state},
                                {"age_years", &years},
                                {"metal_lost_um", &fields.metal_lost},
                                {"metal_left_um", &metal},
                                {"strong", &strong}};
  for (std::size_t k = 0; k < material.layers.size(); ++k)
    arrays.push_back({field_name(material.layers[k].name) + "_um", &fields.layers[k]});
  for (const Mask& mask : masks) arrays.push_back({"mask_" + mask.name, &mask.values});
  write_cells_vtp(file, growth.surface(), arrays);
}

template <typename Of>
PlotCurve curve_of(std::string name, std::span<const CorrosionNumbers> numbers, const Of& of) {
  PlotCurve curve{std::move(name), {}};
  for (const CorrosionNumbers& n : numbers) curve.points.emplace_back(n.years, of(n));
  return curve;
}

Plot share_plot(const std::string& title, std::span<const CorrosionNumbers> numbers) {
  Plot plot{"Corroded surface: " + title, "time (years)", "share of the surface (%)", {}, {}};
  plot.curves.push_back(curve_of("corroded", numbers, [](const auto& n) { return 100.0 * n.share; }));
  if (numbers.back().gone > 0)
    plot.curves.push_back(curve_of("without metal", numbers, [](const auto& n) {
      return n.corroded > 0 ? 100.0 * n.share * static_cast<double>(n.gone) / static_cast<double>(n.corroded)
                            : 0.0;
    }));
  plot.y_low = 0.0;
  plot.y_high = 100.0;
  const auto half =
      std::find_if(numbers.begin(), numbers.end(), [](const auto& n) { return n.share >= 0.5; });
  if (half != numbers.end())
    plot.marks.push_back({half->years, fmt::format("half after {:.1f} years", half->years)});
  return plot;
}

Plot loss_plot(const std::string& title, std::span<const CorrosionNumbers> numbers) {
  Plot plot{"Metal lost: " + title, "time (years)", "depth (µm)", {}, {}};
  plot.curves.push_back(curve_of("deepest", numbers, [](const auto& n) { return n.greatest_depth; }));
  plot.curves.push_back(
      curve_of("mean of corroded cells", numbers, [](const auto& n) { return n.mean_depth_corroded; }));
  plot.curves.push_back(curve_of(fmt::format("mean of all; {:.4g} g/m² in the end", numbers.back().mass_loss),
                                 numbers, [](const auto& n) { return n.mean_depth; }));
  plot.curves.back().style = PlotCurve::Style::dashed;
  return plot;
}

// Sizes at four moments on the way, for in the end there is mostly one spot.
Plot spots_plot(const std::string& title, std::span<const CorrosionNumbers> numbers) {
  Plot plot{"Sizes of spots: " + title, "cells of a spot", "spots", {}, {}};
  plot.log_x = plot.log_y = true;
  for (const double share : {0.01, 0.05, 0.2, 0.6}) {
    const auto found = std::find_if(numbers.begin(), numbers.end(),
                                    [&](const auto& n) { return n.spots && n.share >= share; });
    if (found == numbers.end()) continue;
    PlotCurve curve{fmt::format("{:.3g} years, {:.0f} % corroded", found->years, 100.0 * found->share), {}};
    const std::vector<std::uint64_t> counts = spot_histogram(*found->spots);
    for (std::size_t k = 0; k < counts.size(); ++k)
      if (counts[k] > 0) curve.points.emplace_back(std::exp2(static_cast<double>(k) + 0.5), counts[k]);
    plot.curves.push_back(curve);
    curve.name.clear();
    curve.style = PlotCurve::Style::dots;
  }
  return plot;
}

}  // namespace

std::vector<std::string> write_corrosion(const std::filesystem::path& out, const CorrosionGrowth& growth,
                                         const Material& material, const CorrosionPlan& plan,
                                         std::span<const Mask> masks, bool cells) {
  const std::vector<CorrosionNumbers> numbers = corrosion_history(growth, material, plan);
  std::vector<std::string> files;
  if (cells) {
    write_cells(out / "cells.vtp", growth, material, plan, masks);
    files.emplace_back("cells.vtp");
  }
  write_corrosion_csv(out / "statistics.csv", numbers);
  write_spots_csv(out / "spots.csv", numbers);
  const std::string title = fmt::format("{}, {}", material.name, plan.exposure);
  write_png(draw_plot(share_plot(title, numbers)), out / "share.png");
  write_png(draw_plot(loss_plot(title, numbers)), out / "loss.png");
  write_png(draw_plot(spots_plot(title, numbers)), out / "spots.png");
  for (const char* name : {"statistics.csv", "spots.csv", "share.png", "loss.png", "spots.png"})
    files.emplace_back(name);
  return files;
}

std::vector<std::string> draw_corrosion(const std::filesystem::path& out, const CorrosionGrowth& growth,
                                        const Material& material, const Scene& scene) {
  PatinaPainter painter(growth, material, scene);
  const Camera camera = camera_of(growth.surface().mesh(), scene.picture);
  const double now = static_cast<double>(growth.steps()) * scene.corrosion.step_years;
  std::vector<std::string> files;
  for (const double years : scene.corrosion.frames) {
    if (years > now * (1.0 + 1e-9)) continue;
    files.push_back(picture_name(years));
    write_png(painter.draw(years, camera), out / files.back());
  }
  write_png(painter.draw(now, camera), out / "picture.png");
  files.emplace_back("picture.png");
  return files;
}
