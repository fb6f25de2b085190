#include "scene_corrosion.hpp"

#include "scene_table.hpp"
#include "scene_text.hpp"
#include "verdigris/material/growth_law.hpp"

namespace verdigris::io {

CorrosionPlan read_corrosion(const std::filesystem::path& file, const toml::table& root) {
  CorrosionPlan plan;
  const Table table(file, root, "corrosion");
  if (!table) return plan;
  table.only({"material", "exposure", "step_years", "frames", "exaggerate", "unit_mm", "holes", "occlusion"});
  table.text("material", plan.material);
  if (plan.material.empty())
    table.fail(table.raw(), "[corrosion] names no material", "write material = \"copper\"");
  if (plan.material.ends_with(".toml")) plan.material = (file.parent_path() / plan.material).string();
  table.text("exposure", plan.exposure);
  try {
    exposure_class_named(plan.exposure);
  } catch (const InputError& error) {
    table.fail(*table.find("exposure"), error.problem(), error.remedy());
  }
  table.number("step_years", plan.step_years, 1e-9, 1e6);
  if (table.find("step_years") == nullptr)
    table.fail(table.raw(), "[corrosion] has no step_years", "write the length of a step in years");
  if (const toml::array* frames = table.array("frames"))
    for (const toml::node& node : *frames) plan.frames.push_back(table.number_of(node, "frames", 0.0, 1e9));
  table.number("exaggerate", plan.exaggerate, 0.0, 1e9);
  table.number("unit_mm", plan.unit_mm, 0.0, 1e12);
  table.flag("holes", plan.holes);
  table.flag("occlusion", plan.occlusion);
  return plan;
}

std::string corrosion_text(const CorrosionPlan& plan, const std::filesystem::path& file) {
  if (plan.empty()) return "";
  std::string frames;
  for (const double years : plan.frames) frames += (frames.empty() ? "" : ", ") + exact(years);
  return fmt::format(
      "\n[corrosion]\nmaterial = {}\nexposure = {}\nstep_years = {}\nframes = [{}]\nexaggerate = {}\n"
      "unit_mm = {}\nholes = {}\nocclusion = {}\n",
      plan.material.ends_with(".toml") ? path_from(file, plan.material) : quoted(plan.material),
      quoted(plan.exposure), exact(plan.step_years), frames, exact(plan.exaggerate), exact(plan.unit_mm),
      plan.holes, plan.occlusion);
}

}  // namespace verdigris::io
