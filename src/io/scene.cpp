#include "verdigris/io/scene.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "file_bytes.hpp"
#include "scene_animation.hpp"
#include "scene_corrosion.hpp"
#include "scene_masks.hpp"
#include "scene_table.hpp"
#include "scene_text.hpp"
#include "scene_weathering.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"

namespace verdigris {

LinkKind link_kind_named(const std::string& name) {
  if (name == "unfolded") return LinkKind::unfolded;
  if (name == "projected") return LinkKind::projected;
  throw InputError("links", fmt::format("there is no kind '{}'", name), "choose unfolded or projected");
}

void check_mask_on(const std::string& name, const std::string& where) {
  if (!name.empty() && name != "vertices" && name != "faces")
    throw InputError(where, fmt::format("a mask cannot be on '{}'", name), "choose vertices or faces");
}

const char* name_of(LinkKind kind) {
  return kind == LinkKind::unfolded ? "unfolded" : "projected";
}

namespace {

using io::Table;

constexpr double most = std::numeric_limits<double>::max();
constexpr std::int64_t most_whole = std::numeric_limits<std::int64_t>::max();

void read_torus(const Table& mesh, TorusPlan& torus) {
  mesh.whole("patch", torus.patch, 4, 1 << 20);
  const toml::array* size = mesh.array("torus");
  if (size == nullptr) {
    if (mesh.find("patch") != nullptr)
      mesh.fail(*mesh.find("patch"), "mesh.patch is for a torus", "write torus = [4096, 4096], or remove it");
    return;
  }
  if (size->size() != 2) mesh.fail(*size, "mesh.torus is no size", "write [width, height] in cells");
  torus.width = static_cast<std::uint32_t>(mesh.whole_of(*size->get(0), "torus", 4, 1 << 20));
  torus.height = static_cast<std::uint32_t>(mesh.whole_of(*size->get(1), "torus", 4, 1 << 20));
}

void read_seeds(const Table& seeds, const std::filesystem::path& base, SeedPlan& plan) {
  seeds.only({"count", "points", "file", "vertices", "weights"});
  seeds.whole("count", plan.count, 1, most_whole);
  std::string file;
  seeds.text("file", file);
  if (!file.empty()) plan.points = read_points(base / file);
  if (const toml::array* points = seeds.array("points"))
    for (const toml::node& node : *points) {
      const toml::array* p = node.as_array();
      if (p == nullptr || p->size() < 3 || p->size() > 4)
        seeds.fail(node, "seeds.points holds something that is no point",
                   "write [x, y, z] or [x, y, z, weight]");
      WeightedPoint point;
      for (std::size_t k = 0; k < 3; ++k)
        point.position[static_cast<int>(k)] = seeds.number_of(*p->get(k), "points", -most, most);
      if (p->size() == 4)
        point.weight = seeds.number_of(*p->get(3), "points", std::numeric_limits<double>::min(), most);
      plan.points.push_back(point);
    }
  if (const toml::array* vertices = seeds.array("vertices"))
    for (const toml::node& node : *vertices)
      plan.vertices.push_back(static_cast<std::uint32_t>(seeds.whole_of(node, "vertices", 0, 0xFFFFFFFF)));
  if (const toml::array* weights = seeds.array("weights"))
    for (const toml::node& node : *weights)
      plan.weights.push_back(seeds.number_of(node, "weights", std::numeric_limits<double>::min(), most));
  const int ways =
      (plan.count > 0) + (seeds.find("points") != nullptr) + !file.empty() + !plan.vertices.empty();
  if (seeds && ways != 1)
    seeds.fail(seeds.raw(), "seeds are given in more than one way, or in none",
               "keep one of count, points, file and vertices");
}

}  // namespace

Scene read_scene(const std::filesystem::path& file) {
  io::FileBytes bytes = io::read_file(file);
  io::prepare_text(bytes, file);
  toml::table root;
  try {
    root = toml::parse(bytes.view(), file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}", file.string(), error.source().begin.line),
                     std::string(error.description()), "correct the TOML at that place");
  }
  for (const auto& [key, node] : root)
    if (key != "verdigris" && key != "mesh" && key != "surface" && key != "behaviour" && key != "seeds" &&
        key != "masks" && key != "barrier" && key != "corrosion" && key != "weathering" &&
        key != "timeline" && key != "run" && key != "picture" && key != "animation")
      throw InputError(fmt::format("{}:{}", file.string(), node.source().begin.line),
                       fmt::format("there is no table '{}'", key.str()),
                       "the tables are: verdigris, mesh, surface, behaviour, seeds, masks, barrier, "
                       "corrosion, weathering, "
                       "timeline, run, picture, animation");

  Scene scene;
  scene.file = file;
  const std::filesystem::path base = file.parent_path();
  const Table about(file, root, "verdigris");
  about.only({"version"});

  const Table mesh(file, root, "mesh");
  mesh.only({"file", "hash", "mend", "torus", "patch"});
  std::string mesh_file;
  mesh.text("file", mesh_file);
  read_torus(mesh, scene.torus);
  if (scene.torus.width != 0 && !mesh_file.empty())
    mesh.fail(mesh.raw(), "both a file and a torus are given", "keep one of them");
  if (scene.torus.width == 0 && mesh_file.empty())
    throw InputError(file.string(), "no mesh is named",
                     "write [mesh] and file = \"model.obj\"; the path is relative to the scene");
  if (!mesh_file.empty()) scene.mesh = base / mesh_file;
  mesh.text("hash", scene.mesh_hash);
  mesh.flag("mend", scene.mend);

  const Table surface(file, root, "surface");
  surface.only({"cells", "cell_size", "links"});
  surface.number("cells", scene.cells, 1.0, 1e12);
  surface.number("cell_size", scene.cell_size, std::numeric_limits<double>::min(), most);
  if (surface.find("cells") != nullptr && surface.find("cell_size") != nullptr)
    surface.fail(surface.raw(), "both cells and cell_size are given", "keep one of them");
  std::string links = name_of(scene.links);
  surface.text("links", links);
  if (links != "unfolded" && links != "projected")
    surface.fail(*surface.find("links"), fmt::format("surface.links is '{}'", links),
                 "choose unfolded or projected");
  scene.links = link_kind_named(links);

  const Table behaviour(file, root, "behaviour");
  behaviour.text("name", scene.behaviour);
  if (behaviour)
    for (const auto& [key, node] : behaviour.raw())
      if (key != "name")
        scene.parameters.emplace_back(std::string(key.str()), behaviour.value_of(node, key.str()));

  read_seeds(Table(file, root, "seeds"), base, scene.seeds);

  scene.masks = io::read_masks(file, root);

  const Table barrier(file, root, "barrier");
  barrier.only({"angle", "mask", "mask_on", "threshold"});
  barrier.number("angle", scene.barrier.angle, 0.0, 181.0);
  std::string mask;
  barrier.text("mask", mask);
  if (!mask.empty()) scene.barrier.mask = base / mask;
  barrier.text("mask_on", scene.barrier.mask_on);
  check_mask_on(scene.barrier.mask_on, file.string());
  barrier.number("threshold", scene.barrier.threshold, -most, most);

  scene.corrosion = io::read_corrosion(file, root);

  const Table run(file, root, "run");
  run.only({"seed", "steps"});
  run.whole("seed", scene.seed, 0, most_whole);
  run.whole("steps", scene.steps, 0, most_whole);

  const Table picture(file, root, "picture");
  picture.only({"draw", "view", "up", "width", "height", "outline"});
  picture.flag("draw", scene.picture.draw);
  picture.text("view", scene.picture.view);
  picture.text("up", scene.picture.up);
  if (scene.picture.up != "y" && scene.picture.up != "z")
    picture.fail(*picture.find("up"), fmt::format("'{}' is no up axis", scene.picture.up), "choose y or z");
  picture.whole("width", scene.picture.width, 1, 8192);
  picture.whole("height", scene.picture.height, 1, 8192);
  picture.flag("outline", scene.picture.outline);

  scene.animation = io::read_animation(file, root);

  std::vector<std::string> mask_names;
  for (const MaskPlan& plan : scene.masks) mask_names.push_back(plan.name);
  scene.weathering = io::read_weathering(file, root, mask_names);
  return scene;
}

using io::exact;
using io::path_from;
using io::quoted;
using io::written;

std::string scene_text(const std::filesystem::path& file, const Scene& scene) {
  std::string text =
      fmt::format("# Repeat this run, to the bit: verdigris run {0}\n# Film it: verdigris animate {0}\n\n",
                  file.filename().string());
  text += fmt::format("[verdigris]\nversion = {}\n\n", quoted(VERDIGRIS_VERSION));
  if (scene.torus.width != 0)
    text += fmt::format("[mesh]\ntorus = [{}, {}]\npatch = {}\n\n", scene.torus.width, scene.torus.height,
                        scene.torus.patch);
  else
    text += fmt::format("[mesh]\nfile = {}\nhash = {}\nmend = {}\n\n", path_from(file, scene.mesh),
                        quoted(scene.mesh_hash), scene.mend);
  text += "[surface]\n";
  text += scene.cell_size > 0.0 ? fmt::format("cell_size = {}\n", exact(scene.cell_size))
                                : fmt::format("cells = {}\n", exact(scene.cells));
  text += fmt::format("links = {}\n\n", quoted(name_of(scene.links)));
  text += fmt::format("[behaviour]\nname = {}\n", quoted(scene.behaviour));
  for (const auto& [name, value] : scene.parameters) text += fmt::format("{} = {}\n", name, written(value));
  const SeedPlan& seeds = scene.seeds;
  if (seeds.count > 0 || !seeds.points.empty() || !seeds.vertices.empty()) {
    text += "\n[seeds]\n";
    if (seeds.count > 0) text += fmt::format("count = {}\n", seeds.count);
    if (!seeds.vertices.empty()) text += fmt::format("vertices = [{}]\n", fmt::join(seeds.vertices, ", "));
    if (!seeds.points.empty()) {
      text += "points = [\n";
      for (const WeightedPoint& p : seeds.points)
        text += fmt::format("  [{}, {}, {}, {}],\n", exact(p.position.x), exact(p.position.y),
                            exact(p.position.z), exact(p.weight));
      text += "]\n";
    }
    if (!seeds.weights.empty()) {
      text += "weights = [";
      for (std::size_t k = 0; k < seeds.weights.size(); ++k)
        text += (k == 0 ? "" : ", ") + exact(seeds.weights[k]);
      text += "]\n";
    }
  }
  for (const MaskPlan& mask : scene.masks) text += io::mask_text(mask, file);
  text += fmt::format("\n[barrier]\nangle = {}\n", exact(scene.barrier.angle));
  text += fmt::format("threshold = {}\n", exact(scene.barrier.threshold));
  if (!scene.barrier.mask.empty())
    text += fmt::format("mask = {}\nmask_on = {}\n", path_from(file, scene.barrier.mask),
                        quoted(scene.barrier.mask_on));
  text += io::corrosion_text(scene.corrosion, file);
  text += fmt::format("\n[run]\nseed = {}\nsteps = {}\n", scene.seed, scene.steps);
  const PicturePlan& picture = scene.picture;
  text += fmt::format("\n[picture]\ndraw = {}\nview = {}\nup = {}\nwidth = {}\nheight = {}\noutline = {}\n",
                      picture.draw, quoted(picture.view), quoted(picture.up), picture.width, picture.height,
                      picture.outline);
  text += io::animation_text(scene.animation);
  text += io::weathering_text(scene.weathering, file);
  return text;
}

void write_scene(const std::filesystem::path& file, const Scene& scene) {
  ReplaceFile out(file);
  out.write(scene_text(file, scene));
  out.commit();
}

}  // namespace verdigris
