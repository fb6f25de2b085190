#include "scene_animation.hpp"

#include <limits>

#include "scene_table.hpp"
#include "scene_text.hpp"

namespace verdigris::io {

namespace {

std::vector<CameraPlan> read_camera(const Table& animation, const std::filesystem::path& file) {
  std::vector<CameraPlan> views;
  const toml::array* list = animation.array("camera");
  if (list == nullptr) return views;
  for (const toml::node& node : *list) {
    const Table table(file, node, "animation.camera");
    table.only({"at", "view", "zoom", "target"});
    CameraPlan view;
    table.number("at", view.at, 0.0, 1.0);
    table.text("view", view.view);
    if (view.view.empty())
      animation.fail(node, "a view of animation.camera has no 'view'",
                     "write view = \"front\" or \"1,0.5,1\"");
    table.number("zoom", view.zoom, 1e-3, 1e3);
    if (const toml::array* target = table.array("target")) {
      if (target->size() != 3) table.fail(*target, "animation.camera.target is no point", "write [x, y, z]");
      constexpr double most = std::numeric_limits<double>::max();
      view.target.emplace();
      for (int k = 0; k < 3; ++k)
        (*view.target)[k] = table.number_of(*target->get(static_cast<std::size_t>(k)), "target", -most, most);
    }
    if (!views.empty() && !(view.at > views.back().at))
      animation.fail(node, "views of animation.camera do not ascend in 'at'", "give each its time, 0 to 1");
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace

AnimationPlan read_animation(const std::filesystem::path& file, const toml::table& root) {
  AnimationPlan plan;
  const Table table(file, root, "animation");
  table.only({"frames", "years", "rate", "hold", "turn", "camera", "overlay"});
  table.whole("frames", plan.frames, 1, 100000);
  table.number("rate", plan.rate, 1.0, 240.0);
  table.whole("hold", plan.hold, 0, 10000);
  table.number("turn", plan.turn, -36000.0, 36000.0);
  table.flag("overlay", plan.overlay);
  if (const toml::array* years = table.array("years"))
    for (const toml::node& node : *years) {
      plan.years.push_back(table.number_of(node, "years", 0.0, 1e9));
      if (plan.years.size() > 1 && plan.years.back() < plan.years[plan.years.size() - 2])
        table.fail(node, "animation.years do not ascend", "sort them");
    }
  if (table.find("years") != nullptr && table.find("frames") != nullptr)
    table.fail(table.raw(), "both frames and years are given", "keep one of them");
  plan.camera = read_camera(table, file);
  return plan;
}

std::string animation_text(const AnimationPlan& plan) {
  if (plan == AnimationPlan{}) return "";
  std::string text = "\n[animation]\n";
  if (plan.years.empty()) {
    text += fmt::format("frames = {}\n", plan.frames);
  } else {
    std::string years;
    for (const double year : plan.years) years += (years.empty() ? "" : ", ") + exact(year);
    text += fmt::format("years = [{}]\n", years);
  }
  text += fmt::format("rate = {}\nhold = {}\nturn = {}\noverlay = {}\n", exact(plan.rate), plan.hold,
                      exact(plan.turn), plan.overlay);
  if (plan.camera.empty()) return text;
  text += "camera = [\n";
  for (const CameraPlan& view : plan.camera) {
    text += fmt::format("  {{ at = {}, view = {}, zoom = {}", exact(view.at), quoted(view.view),
                        exact(view.zoom));
    if (view.target)
      text += fmt::format(", target = [{}, {}, {}]", exact(view.target->x), exact(view.target->y),
                          exact(view.target->z));
    text += " },\n";
  }
  return text + "]\n";
}

}  // namespace verdigris::io
