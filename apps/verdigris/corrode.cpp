// verdigris corrode: metal ages in real time.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "behaviour_options.hpp"
#include "job.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"
#include "verdigris/io/read_material.hpp"

using namespace verdigris;

namespace {

// The material and the clock say what these are.
constexpr std::array<std::string_view, 4> not_asked{"metal", "k1", "k2", "k3"};

struct Options : BehaviourOptions {
  double years = 0.0;  // 0: not given
  std::string step_length, frames;
  bool no_occlusion = false;
};

// "12h", "30d", "2w", "0.5y" in years.
double parse_length(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  const double years = unit == "h"   ? 1.0 / 8766.0
                       : unit == "d" ? 1.0 / 365.25
                       : unit == "w" ? 7.0 / 365.25
                       : unit == "y" ? 1.0
                                     : 0.0;
  if (error != std::errc() || !(value > 0.0) || !std::isfinite(value) || years == 0.0)
    throw InputError("--step-length", fmt::format("'{}' is no length of time", text),
                     "write hours, days, weeks or years: 12h, 30d, 2w, 0.5y");
  return value * years;
}

// Two of years, steps and the length of a step give the third. A front crosses a model of four times the
// cells in twice the steps: 950 for the 220,000 cells of Gobron & Chiba 1999, Fig. 22.
void finish_clock(Options& options) {
  Scene& scene = options.scene;
  CorrosionPlan& plan = scene.corrosion;
  const double years = options.years > 0.0 ? options.years : 30.0;
  if (options.step_length.empty()) {
    const double usual = scene.cell_size > 0.0 ? 2000.0 : 950.0 * std::sqrt(scene.cells / 220e3);
    if (scene.steps == 0) scene.steps = static_cast<std::uint64_t>(std::max(100.0, std::round(usual)));
    plan.step_years = years / static_cast<double>(scene.steps);
  } else {
    plan.step_years = parse_length(options.step_length);
    if (options.years > 0.0 && scene.steps != 0)
      throw InputError("--years, --steps, --step-length", "each two of them give the third", "leave one out");
    const double steps = std::round(years / plan.step_years);
    if (scene.steps == 0) scene.steps = static_cast<std::uint64_t>(std::clamp(steps, 1.0, 1e18));
  }
  if (scene.steps > CorrosionRule::last_step)
    throw InputError("--steps", fmt::format("{} steps are too many", scene.steps),
                     fmt::format("take longer ones: at most {} fit", CorrosionRule::last_step));
}

// A count: so many, spread evenly; or a list of years.
void finish_frames(Options& options) {
  const std::string& text = options.frames;
  std::vector<double>& frames = options.scene.corrosion.frames;
  const char* const last = text.data() + text.size();
  for (const char* p = text.data(); p != last;) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(p, last, value);
    if (error != std::errc() || !(value >= 0.0 && value <= 1e9) || (end != last && *end != ','))
      throw InputError("--frames", fmt::format("'{}' is neither a count nor a list of years", text),
                       "write 6, or 0,0.5,2,10,30");
    frames.push_back(value);
    p = end == last ? end : end + 1;
  }
  if (text.empty() || text.find(',') != std::string::npos) return;
  const double count = frames.front();
  if (count != std::floor(count) || count < 1.0 || count > 10000.0)
    throw InputError("--frames", fmt::format("'{}' is no count of pictures", text),
                     "write 1 to 10000, or years with commas");
  const double all = static_cast<double>(options.scene.steps) * options.scene.corrosion.step_years;
  frames.clear();
  for (int k = 0; k < static_cast<int>(count); ++k)
    frames.push_back(count > 1.0 ? all * k / (count - 1.0) : all);
}

void add_corrosion_options(CLI::App& command, Options& options) {
  CorrosionPlan& plan = options.scene.corrosion;
  plan.material = "copper";
  command
      .add_option("--material", plan.material,
                  fmt::format("One of {}, or a file that ends in .toml", fmt::join(material_names(), ", ")))
      ->type_name("NAME|FILE")
      ->capture_default_str();
  command
      .add_option("--class", plan.exposure,
                  "Corrosivity of the air, ISO 9223: C1 (dry rooms) to C5, CX (sea)")
      ->type_name("CLASS")
      ->capture_default_str();
  command.add_option("--years", options.years, "How long (default 30)")
      ->type_name("Y")
      ->check(within(1e-9, 1e9));
  command.add_option("--step-length", options.step_length, "Length of a step: 12h, 30d, 2w, 0.5y")
      ->type_name("TIME");
  command
      .add_option("--frames", options.frames,
                  "Pictures on the way: how many, or at which ages: 0,0.5,2,10,30")
      ->type_name("N|LIST");
  command
      .add_option("--exaggerate", plan.exaggerate,
                  "Factor on the relief of metal lost and layers grown; 0: flat")
      ->type_name("X")
      ->check(within(0.0, 1e9))
      ->capture_default_str();
  command
      .add_option(
          "--unit", plan.unit_mm,
          "Length of a model unit in millimetres, for the relief (default: 1 for a model of 10 units and "
          "more, else 1000)")
      ->type_name("MM")
      ->check(within(1e-9, 1e12));
  command.add_flag("--holes", plan.holes, "Draw nothing where no metal is left");
  command.add_flag("--no-occlusion", options.no_occlusion, "Light hollows as if they were open: quicker");
}

}  // namespace

void add_corrode(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  const BehaviourEntry entry = corrosion_entry();
  auto* command =
      app.add_subcommand("corrode", "Let metal corrode and grow its patina, in years and micrometres");
  add_corrosion_options(*command, *options);
  add_behaviour_options(*command, options, entry, not_asked);
  command->footer(
      "Writes cells.vtp, statistics.csv, spots.csv, plots of them, pictures, and run.toml, which repeats "
      "the\n"
      "run to the bit. Masks are given in a scene: [masks.NAME].");
  command->callback([options, entry, &status] {
    finish_behaviour_options(*options, entry);
    Scene& scene = options->scene;
    std::erase_if(scene.parameters, [](const auto& pair) {
      return std::find(not_asked.begin(), not_asked.end(), pair.first) != not_asked.end();
    });
    scene.corrosion.occlusion = !options->no_occlusion;
    finish_clock(*options);
    finish_frames(*options);
    status = run_job(scene, options->run);
  });
}
