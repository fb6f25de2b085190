#include "scene_weathering.hpp"

#include "scene_table.hpp"
#include "scene_text.hpp"

namespace verdigris::io {

namespace {

std::vector<TimelineStep> read_timeline(const std::filesystem::path& file, const toml::table& root) {
  std::vector<TimelineStep> steps;
  const toml::node* list = root.get("timeline");
  if (list == nullptr) return steps;
  const auto fail = [&](const toml::node& node, const std::string& what, const std::string& remedy) {
    throw InputError(fmt::format("{}:{}", file.string(), node.source().begin.line), what, remedy);
  };
  if (!list->is_array_of_tables())
    fail(*list, "'timeline' is not a list of tables", "write [[timeline]] for each operation");
  for (const toml::node& node : *list->as_array()) {
    const toml::table& table = *node.as_table();
    TimelineStep step;
    step.where = fmt::format("{}:{}", file.string(), table.source().begin.line);
    for (const auto& [key, value] : table) {
      const bool number = value.is_number();
      if (!number && !value.is_string())
        fail(value, fmt::format("timeline.{} is no number and no string", key.str()),
             "write a number, or a text in quotes");
      if (key == "op") {
        if (!value.is_string()) fail(value, "timeline.op is not a string", "put it in quotes");
        step.op = value.as_string()->get();
      } else if (number) {
        // toml++ gives no double for whole numbers that one does not hold exactly.
        step.values.emplace_back(std::string(key.str()), value.is_integer()
                                                             ? static_cast<double>(value.as_integer()->get())
                                                             : value.as_floating_point()->get());
      } else {
        step.values.emplace_back(std::string(key.str()), value.as_string()->get());
      }
    }
    if (step.op.empty())
      fail(table, "an operation of the timeline has no 'op'", "write op = \"coat\", \"age\", ...");
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace

WeatheringPlan read_weathering(const std::filesystem::path& file, const toml::table& root,
                               const std::vector<std::string>& own_masks) {
  WeatheringPlan plan;
  const Table table(file, root, "weathering");
  if (!table) {
    if (const toml::node* list = root.get("timeline"))
      throw InputError(fmt::format("{}:{}", file.string(), list->source().begin.line),
                       "there is a timeline, and no [weathering]",
                       "write [weathering] and material = \"copper\"");
    return plan;
  }
  table.only({"material", "exaggerate", "unit_mm", "occlusion"});
  table.text("material", plan.material);
  if (plan.material.empty())
    table.fail(table.raw(), "[weathering] names no material", "write material = \"copper\"");
  if (plan.material.ends_with(".toml")) plan.material = (file.parent_path() / plan.material).string();
  table.number("exaggerate", plan.exaggerate, 0.0, 1e9);
  table.number("unit_mm", plan.unit_mm, 1e-9, 1e12);
  table.flag("occlusion", plan.occlusion);
  plan.timeline = read_timeline(file, root);
  if (plan.timeline.empty())
    table.fail(table.raw(), "nothing happens in [weathering]", "write [[timeline]] for each operation");
  check_timeline(builtin_operators(), plan.timeline, mask_book_names(own_masks));
  return plan;
}

std::string weathering_text(const WeatheringPlan& plan, const std::filesystem::path& file) {
  if (plan.empty()) return "";
  std::string text =
      fmt::format("\n[weathering]\nmaterial = {}\nexaggerate = {}\nunit_mm = {}\nocclusion = {}\n",
                  plan.material.ends_with(".toml") ? path_from(file, plan.material) : quoted(plan.material),
                  exact(plan.exaggerate), exact(plan.unit_mm), plan.occlusion);
  for (const TimelineStep& step : plan.timeline) {
    text += fmt::format("\n[[timeline]]\nop = {}\n", quoted(step.op));
    for (const auto& [name, value] : step.values) text += fmt::format("{} = {}\n", name, written(value));
  }
  return text;
}

}  // namespace verdigris::io
