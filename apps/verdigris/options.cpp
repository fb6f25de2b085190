#include "options.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>

#include "verdigris/base/error.hpp"

using verdigris::InputError;
using verdigris::Scene;

namespace {

// The leading number of `text`; what follows it in `rest`.
bool leading_number(const std::string& text, double& value, std::string& rest) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return false;
  rest.assign(end, text.data() + text.size());
  return true;
}

}  // namespace

double parse_count(const std::string& text, const char* option) {
  double value = 0.0;
  std::string rest;
  bool good = leading_number(text, value, rest);
  if (good && !rest.empty()) {
    const double factor = rest == "k" || rest == "K" ? 1e3 : rest == "M" ? 1e6 : rest == "G" ? 1e9 : 0.0;
    good = factor > 0.0;
    value *= factor;
  }
  if (!good || !std::isfinite(value) || value < 1.0)
    throw InputError(option, fmt::format("'{}' is not a count of at least 1", text),
                     "write 250000, 1e6, 64k, 1M or 2.5G");
  return value;
}

namespace {
bool two_numbers(const std::string& text, int most, int& width, int& height) {
  const auto x = text.find('x');
  const auto whole = [&](std::size_t from, std::size_t to, int& value) {
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, value);
    return error == std::errc() && end == text.data() + to && value >= 1 && value <= most;
  };
  return x != std::string::npos && whole(0, x, width) && whole(x + 1, text.size(), height);
}
}  // namespace

void parse_size(const std::string& text, int& width, int& height) {
  if (!two_numbers(text, 8192, width, height))
    throw InputError("--size", fmt::format("'{}' is no picture size", text),
                     "write WIDTHxHEIGHT in pixels, up to 8192, as in 1280x960");
}

void parse_torus(const std::string& text, int& width, int& height) {
  if (!two_numbers(text, 1 << 20, width, height))
    throw InputError("--torus", fmt::format("'{}' is no size of a grid", text),
                     "write WIDTHxHEIGHT in cells, as in 4096x4096");
}

std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

CLI::Validator within(double least, double greatest) {
  return CLI::Validator(
      [=](std::string& text) {
        double value = 0.0;
        std::string rest;
        return leading_number(text, value, rest) && rest.empty() && value >= least && value <= greatest
                   ? std::string()
                   : fmt::format("'{}' is not a number from {:g} to {:g}", text, least, greatest);
      },
      fmt::format("{:g} .. {:g}", least, greatest));
}

std::string short_text(const verdigris::ParameterValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{:.4g}", *number) : std::get<std::string>(value);
}

void add_surface_options(CLI::App& app, Scene& scene, SurfaceOptionTexts& texts) {
  auto* cells = app.add_option("--cells", texts.cells, "Cells in all, about: 250000, 64k, 1M (default 1M)")
                    ->type_name("N");
  app.add_option("--cell-size", texts.cell_size, "Side of a cell in model units, instead of --cells")
      ->type_name("LENGTH")
      ->excludes(cells);
  app.add_option("--links", texts.links,
                 "Joints between triangles: unfolded (default), or projected as in the 1999 paper")
      ->type_name("KIND");
  app.add_flag("--mend", scene.mend, "Remove duplicate faces and make orientation consistent first");
}

void finish_surface_options(Scene& scene, const SurfaceOptionTexts& texts) {
  if (!texts.cells.empty()) scene.cells = parse_count(texts.cells, "--cells");
  if (!texts.cell_size.empty()) {
    std::string rest;
    double value = 0.0;
    if (!leading_number(texts.cell_size, value, rest) || !rest.empty() || !std::isfinite(value) ||
        !(value > 0.0))
      throw InputError(
          "--cell-size", fmt::format("'{}' is not a positive length", texts.cell_size),
          "give a length in model units, or a count with --cells; 'verdigris info' suggests one");
    scene.cell_size = value;
  }
  if (!texts.links.empty()) scene.links = verdigris::link_kind_named(texts.links);
}

void add_picture_options(CLI::App& app, Scene& scene, PictureOptionTexts& texts) {
  app.add_option("--view", scene.picture.view,
                 "front, back, left, right, top, bottom, iso, or a direction x,y,z")
      ->type_name("VIEW")
      ->capture_default_str();
  app.add_option("--up", scene.picture.up, "Axis of the model that points up: y or z")
      ->check(CLI::IsMember({"y", "z"}))
      ->type_name("AXIS")
      ->capture_default_str();
  app.add_option("--size", texts.size, "Picture size in pixels (default 1280x960)")->type_name("WxH");
  app.add_flag("--no-picture", texts.no_picture, "Write data only; needs no OpenGL");
  app.add_flag("--no-outline", texts.no_outline, "Draw no lines between regions");
}

void finish_picture_options(Scene& scene, const PictureOptionTexts& texts) {
  if (!texts.size.empty()) parse_size(texts.size, scene.picture.width, scene.picture.height);
  if (texts.no_picture) scene.picture.draw = false;
  if (texts.no_outline) scene.picture.outline = false;
}

void add_scene_overrides(CLI::App& app, SceneOverrides& overrides) {
  app.add_option("--mesh", overrides.mesh, "Another model than the scene's")->type_name("MODEL");
  app.add_option("--cells", overrides.cells, "Another number of cells: 250000, 500k, 2M")->type_name("N");
  app.add_option("--view", overrides.view, "Another view: front, iso, or a direction x,y,z")
      ->type_name("VIEW");
  app.add_option("--up", overrides.up, "Axis of the model that points up: y or z")
      ->type_name("AXIS")
      ->check(CLI::IsMember({"y", "z"}));
  app.add_option("--size", overrides.size, "Another picture size in pixels")->type_name("WxH");
}

void apply(const SceneOverrides& overrides, Scene& scene) {
  if (!overrides.mesh.empty()) {
    scene.mesh = overrides.mesh;
    scene.mesh_hash.clear();
  }
  if (!overrides.cells.empty()) {
    scene.cells = parse_count(overrides.cells, "--cells");
    scene.cell_size = 0.0;
  }
  if (!overrides.view.empty()) {
    scene.picture.view = overrides.view;
    scene.animation.camera.clear();
  }
  if (!overrides.up.empty()) scene.picture.up = overrides.up;
  if (!overrides.size.empty()) parse_size(overrides.size, scene.picture.width, scene.picture.height);
}

void add_run_options(CLI::App& app, RunOptions& options, bool checkpoints) {
  app.add_option("--out,-o", options.out, "Directory for the results; made if need be")
      ->type_name("DIR")
      ->capture_default_str();
  app.add_option("--threads", options.threads, "Threads to use (default: all cores); the result is the same")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  if (checkpoints) {
    app.add_option("--checkpoint-every", options.checkpoint_every,
                   "Write checkpoint.vgc into the directory every so many steps, or every 30s, 5m, 2h; "
                   "a stopped run always writes one, a complete one removes it")
        ->type_name("N|TIME");
    app.add_flag("--resume", options.resume,
                 "Go on from the checkpoint in the directory; all but --steps, --threads and the picture "
                 "must be as it was then");
  }
  app.add_flag("--no-cells", options.no_cells, "Do not write cells.vtp (48 bytes and more a cell)");
  app.add_flag("--json", options.json, "Report as one JSON object on standard output");
  app.add_flag("--quiet,-q", options.quiet, "No progress and no report");
}
