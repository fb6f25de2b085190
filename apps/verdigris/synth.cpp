// A command for each primitive of synthesis: as a picture of heights, as land, as a field on a model.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "idle_options.hpp"
#include "model.hpp"
#include "picture.hpp"
#include "thread_option.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/surface_field.hpp"
#include "verdigris/io/replace_file.hpp"
#include "verdigris/io/write_cells.hpp"
#include "verdigris/io/write_mesh.hpp"
#include "verdigris/io/write_png.hpp"
#include "verdigris/picture/shaded_heights.hpp"
#include "verdigris/synthesis/builtin.hpp"
#include "verdigris/synthesis/height_map.hpp"
#include "verdigris/synthesis/stretch_to_unit.hpp"
#include "verdigris/terrain/height_mesh.hpp"

using namespace verdigris;

namespace {

struct Options {
  std::map<std::string, std::string> parameters;
  std::string size, out, mesh, on;
  std::uint64_t seed = 1;
  int threads = 0, width = 1024, height = 1024;
  double section = 0.0, low = 0.0, high = 0.0, relief = 0.15, scale = 1.0;
  bool shaded = false, solid = false, json = false, quiet = false;
  Scene scene;
  SurfaceOptionTexts surface;
};

// What was made of a primitive, whatever of.
struct Report {
  ValueRange range;  ///< what is black and white
  float least = 0.0f, greatest = 0.0f;
  std::size_t samples = 0, outside = 0, triangles = 0;
  std::vector<std::string> files;
};

ParameterValues given_parameters(const Options& options, const PrimitiveEntry& entry) {
  ParameterValues values;
  for (const ParameterInfo& p : entry.parameters)
    if (const std::string& text = options.parameters.at(p.name); !text.empty())
      values.emplace_back(p.name, parse_parameter("--" + p.name, p, text));
  return values;
}

// What is to be 0 and 1: as asked for, or what the field says of itself.
ValueRange stretch(const Options& options, const CLI::App& command, const ScalarField& field) {
  ValueRange range = field.range();
  constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
  for (const auto& [name, number, end] : {std::tuple("--low", options.low, &range.least),
                                          std::tuple("--high", options.high, &range.greatest)}) {
    if (command.count(name) == 0) continue;
    if (!(std::abs(number) <= most))
      throw InputError(name, fmt::format("{} is no number, or too large", number), "give one up to 3e38");
    *end = static_cast<float>(number);
  }
  if (range.least == range.greatest)
    throw InputError("--low, --high", fmt::format("both are {}", range.least),
                     "leave some range between them");
  if (const double width = static_cast<double>(range.greatest) - static_cast<double>(range.least);
      !(std::abs(1.0 / width) <= most))
    throw InputError("--low, --high", fmt::format("there is only {} between them", width),
                     "leave more range between them");
  return range;
}

void measure(Report& report, float value) {
  if (report.samples++ == 0) report.least = report.greatest = value;
  report.least = std::min(report.least, value);
  report.greatest = std::max(report.greatest, value);
  const auto [low, high] = std::minmax(report.range.least, report.range.greatest);
  report.outside += static_cast<std::size_t>(value < low || value > high);
}

std::string ending_of(const std::string& file) {
  return std::filesystem::path(file).extension().string();
}

// N or WxH.
void parse_samples(const std::string& text, int& width, int& height) {
  const auto cross = text.find('x');
  const auto whole = [&](std::size_t from, std::size_t to, int& value) {
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, value);
    return error == std::errc() && end == text.data() + to && value >= 1 && value <= 8192;
  };
  const bool good = cross == std::string::npos
                        ? whole(0, text.size(), width) && whole(0, text.size(), height)
                        : whole(0, cross, width) && whole(cross + 1, text.size(), height);
  if (!good)
    throw InputError("--size", fmt::format("'{}' is neither N nor WxH", text),
                     "write so many samples along a side, or WIDTHxHEIGHT, up to 8192: 1024 or 1280x960");
}

// What cannot be is said before anything is made or written.
void check_heights(Options& options, const CLI::App& command) {
  refuse_idle(command, {"--cells", "--cell-size", "--links", "--mend", "--view", "--up", "--scale"},
              "there is no model to lay the field on", "name one with --on, or leave it out");
  if (options.mesh.empty())
    refuse_idle(command, {"--solid"}, "there is no land to close",
                "ask for land with --mesh, or leave it out");
  if (options.mesh.empty() && !options.shaded)
    refuse_idle(command, {"--relief"}, "grey heights have no relief",
                "ask for --shaded or --mesh, or leave it out");
  if (options.out.empty())
    refuse_idle(command, {"--shaded"}, "there is no picture beside the land",
                "name one with --out, or leave it out");
  if (!options.size.empty()) parse_samples(options.size, options.width, options.height);
  if (!options.out.empty() && ending_of(options.out) != ".png")
    throw InputError("--out", fmt::format("'{}' is no format of pictures", ending_of(options.out)),
                     "give a name that ends in .png");
  if (options.mesh.empty()) return;
  if (const std::string ending = ending_of(options.mesh); ending != ".obj" && ending != ".ply")
    throw InputError("--mesh", fmt::format("meshes are not written as '{}'", options.mesh),
                     "give a name that ends in .obj or .ply");
  if (options.width < 2 || options.height < 2)
    throw InputError("--size", fmt::format("{} x {} heights make no land", options.width, options.height),
                     "give 2 or more");
}

void check_on_model(Options& options, const CLI::App& command) {
  refuse_idle(command, {"--mesh", "--solid", "--relief", "--shaded", "--section"},
              "a field on a model makes no land and no map", "leave it out, or leave out --on");
  const std::string ending = ending_of(options.out);
  if (ending != ".png" && ending != ".vtp")
    throw InputError("--out", fmt::format("'{}' is no format of fields on a model", ending),
                     "give a name that ends in .png (a picture) or .vtp (its cells)");
  if (ending == ".vtp")
    refuse_idle(command, {"--size", "--view", "--up"}, "the cells are written, not a picture of them",
                "leave it out, or give a name that ends in .png with --out");
  options.scene.mesh = options.on;
  if (ending == ".png") {
    if (!options.size.empty())
      parse_size(options.size, options.scene.picture.width, options.scene.picture.height);
    check_picture(options.scene.picture);
  }
  finish_surface_options(options.scene, options.surface);
}

void write_heights(const Options& options, const ScalarField& field, Report& report) {
  const int width = options.width, height = options.height;
  HeightMap map = sample_heights(field, width, height, options.section);
  for (const float value : map.values) measure(report, value);
  stretch_to_unit(map.values, static_cast<double>(report.range.least),
                  static_cast<double>(report.range.greatest));
  if (!options.out.empty()) {
    if (options.shaded) {
      write_png(shaded_heights(map.values, width, height, options.relief), options.out);
    } else {
      GreyImage image{width, height, {}};
      image.levels.reserve(map.values.size());
      for (const float value : map.values)
        image.levels.push_back(static_cast<std::uint16_t>(value * 65535.0f + 0.5f));
      write_grey_png(image, options.out);
    }
    report.files.push_back(options.out);
  }
  if (!options.mesh.empty()) {
    const double side = map.step * (width - 1), top = options.relief * side;
    const Mesh mesh = options.solid ? height_solid(map, top, -0.1 * side) : height_mesh(map, top);
    write_mesh(options.mesh, mesh);
    report.triangles = mesh.triangles.size();
    report.files.push_back(options.mesh);
  }
}

void write_on_model(Options& options, const std::string& name, const ScalarField& field, Report& report) {
  const Surface surface = lay_cells(load_model(options.scene).mesh, options.scene);
  Field<float> values = field_on_surface(surface, field, {options.scale});
  for (std::uint32_t r = 0; r < surface.rows().size(); ++r)
    for (std::uint32_t slot = surface.owned(r).begin; slot < surface.owned(r).end; ++slot)
      measure(report, values[slot]);
  if (ending_of(options.out) == ".vtp") {
    const CellArray array{name, &values};
    write_cells_vtp(options.out, surface, {&array, 1});
  } else {
    stretch_to_unit(values, static_cast<double>(report.range.least),
                    static_cast<double>(report.range.greatest));
    write_picture(options.out, surface, values, false, options.scene.picture);
  }
  report.files.push_back(options.out);
}

void print(const Options& options, const PrimitiveEntry& entry, const ParameterValues& values,
           const Report& r) {
  if (options.json) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
    for (const auto& [name, value] : values)
      std::visit([&, key = name](const auto& v) { parameters[key] = v; }, value);
    const nlohmann::ordered_json report{
        {"primitive", entry.name},  {"parameters", parameters}, {"seed", options.seed},
        {"samples", r.samples},     {"least", r.least},         {"greatest", r.greatest},
        {"low", r.range.least},     {"high", r.range.greatest}, {"outside", r.outside},
        {"triangles", r.triangles}, {"files", r.files}};
    fmt::print("{}\n", report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!options.quiet) {
    const bool grey = options.on.empty() && !options.shaded && !options.out.empty();
    fmt::print("{}: {} values from {:.4g} to {:.4g}; drawn from {:.4g}{} to {:.4g}{}", entry.name, r.samples,
               r.least, r.greatest, r.range.least, grey ? " (black)" : "", r.range.greatest,
               grey ? " (white)" : "");
    if (r.outside > 0)
      fmt::print("; {:.1f} % beyond",
                 100.0 * static_cast<double>(r.outside) / static_cast<double>(r.samples));
    fmt::print("\n");
    if (r.triangles > 0) fmt::print("land of {} triangles\n", r.triangles);
    fmt::print("written to {}\n", fmt::join(r.files, ", "));
  }
}

void run(Options& options, const CLI::App& command, const PrimitiveEntry& entry) {
  for (const double number : {options.section, options.relief, options.scale})
    if (!std::isfinite(number))
      throw InputError("--section, --relief, --scale", fmt::format("{} is not a number", number),
                       "give a number");
  const ParameterValues values = given_parameters(options, entry);
  if (options.out.empty() && options.mesh.empty()) options.out = entry.name + ".png";
  if (options.on.empty())
    check_heights(options, command);
  else
    check_on_model(options, command);
  const ThreadLimit threads(options.threads);
  for (const std::string& file : {options.out, options.mesh})
    if (!file.empty()) remove_abandoned(file);
  const auto field = entry.create(values, options.seed);
  Report report;
  report.range = stretch(options, command, *field);
  if (options.on.empty())
    write_heights(options, *field, report);
  else
    write_on_model(options, entry.name, *field, report);
  print(options, entry, values, report);
}

void add_primitive(CLI::App& synth, const PrimitiveEntry& entry) {
  auto options = std::make_shared<Options>();
  auto* command = synth.add_subcommand(entry.name, sentence(entry.summary));
  for (const ParameterInfo& p : entry.parameters) {
    const std::string choices = p.choices.empty() ? "" : fmt::format(": {}", fmt::join(p.choices, ", "));
    command
        ->add_option("--" + p.name, options->parameters[p.name],
                     fmt::format("{}{} (default {})", p.help, choices, short_text(p.default_value)))
        ->type_name(p.is_text() ? "TEXT" : "X");
  }
  command->add_option("--seed", options->seed, "Seed of the random numbers")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{std::numeric_limits<std::int64_t>::max()}))
      ->capture_default_str();
  command
      ->add_option("--size", options->size, "Samples along a side, or WxH (default 1024; with --on 1280x960)")
      ->type_name("N|WxH");
  command
      ->add_option(
          "--out,-o", options->out,
          fmt::format("16-bit grey PNG of heights; with --on, .png or .vtp (default {}.png)", entry.name))
      ->type_name("FILE");
  command->add_flag("--shaded", options->shaded,
                    "A coloured map, lit from the upper left, in place of grey heights");
  command->add_option("--section", options->section, "Where z is cut, in units of the field")
      ->type_name("Z")
      ->capture_default_str();
  command->add_option("--low", options->low, "Value that becomes 0 (default: the field's least)")
      ->type_name("X");
  command->add_option("--high", options->high, "Value that becomes 1 (default: its greatest)")
      ->type_name("X");
  command->add_option("--mesh", options->mesh, "Also the land as a mesh: .obj or .ply")->type_name("FILE");
  command->add_option("--relief", options->relief, "How high 1 stands, as a share of the width")
      ->type_name("X")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  command->add_flag("--solid", options->solid, "Close the land with walls and a floor");
  command->add_option("--on", options->on, "Lay the field on this model instead")->type_name("MODEL");
  command->add_option("--scale", options->scale, "With --on: how many windows of the field the model spans")
      ->type_name("X")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str();
  add_surface_options(*command, options->scene, options->surface);
  command->add_option("--view", options->scene.picture.view, "With --on: front, left, top, iso, x,y,z, ...")
      ->type_name("VIEW")
      ->capture_default_str();
  command
      ->add_option("--up", options->scene.picture.up, "With --on: axis of the model that points up: y or z")
      ->type_name("AXIS")
      ->capture_default_str();
  add_thread_option(*command, options->threads);
  command->add_flag("--json", options->json, "Report as one JSON object on standard output");
  command->add_flag("--quiet,-q", options->quiet, "No report");
  command->callback([options, command, entry] { run(*options, *command, entry); });
}

}  // namespace

void add_synth(CLI::App& app) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  auto* synth =
      app.add_subcommand("synth", "Noise, fractals and L-systems as heights, land, or fields on models");
  auto list = std::make_shared<bool>(false);
  synth->add_flag("--list", *list, "The primitives and their parameters");
  synth->footer("Example: verdigris synth ridged --h 0.9 --size 513 --out alps.png --mesh alps.ply --solid");
  synth->require_subcommand(0, 1);
  for (const PrimitiveEntry& entry : catalogue.entries()) add_primitive(*synth, entry);
  synth->callback([synth, list] {
    if (*list)
      print_primitives();
    else if (synth->get_subcommands().empty())
      throw InputError("synth", "no primitive is named", "name one; verdigris synth --list shows them");
  });
}
