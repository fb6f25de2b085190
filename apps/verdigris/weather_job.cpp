#include "weather_job.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>

#include "model.hpp"
#include "picture.hpp"
#include "prepared_timeline.hpp"
#include "result_place.hpp"
#include "thread_option.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/write_png.hpp"
#include "verdigris/io/write_weathering.hpp"
#include "weather_pictures.hpp"

using namespace verdigris;

namespace {

// Words or JSON on standard output.
void report(const Scene& scene, const Surface& surface, const std::vector<TimelineRecord>& records,
            const std::vector<std::string>& files, double seconds, bool complete, const RunOptions& options) {
  if (options.json) {
    nlohmann::ordered_json all{{"model", model_name(scene)},
                               {"cells", surface.owned_count()},
                               {"complete", complete},
                               {"seconds", seconds},
                               {"operations", nlohmann::ordered_json::array()},
                               {"out", options.out},
                               {"files", files}};
    for (const TimelineRecord& r : records) {
      nlohmann::ordered_json one{{"op", r.op}, {"years", r.years}, {"cells", r.report.cells}};
      for (const auto& [name, value] : r.report.numbers) one[name] = value;
      one["seconds"] = r.seconds;
      all["operations"].push_back(one);
    }
    fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return;
  }
  fmt::print("{}: {} cells of {:.4g}, {}\n", model_name(scene), surface.owned_count(), surface.cell_size(),
             scene.weathering.material);
  for (std::size_t k = 0; k < records.size(); ++k) {
    const TimelineRecord& r = records[k];
    fmt::print("{:3} {:8} {:6.1f} years  {:5.1f} % bare, {:5.1f} % corroded, {:.3g} g/m2 lost  ({:.2f} s)\n",
               k + 1, r.op, r.years, 100.0 * r.numbers.bare, 100.0 * r.numbers.corroded, r.numbers.mass_loss,
               r.seconds);
  }
  fmt::print("{:.2f} s; {} in {}\n", seconds, fmt::join(files, ", "), options.out);
}

}  // namespace

int run_weathering(Scene scene, const RunOptions& options) {
  const ThreadLimit threads(options.threads);
  if (options.resume || !options.checkpoint_every.empty())
    throw InputError("--resume, --checkpoint-every", "timelines keep no checkpoints",
                     "run the scene from its beginning");
  check_timeline_scene(scene);
  check_inputs(scene, options.out);
  const auto begin = std::chrono::steady_clock::now();
  Progress progress(!options.quiet);
  watch_for_interrupt();

  PreparedTimeline timeline(scene, progress, options.quiet);
  const Surface& surface = timeline.surface();
  CoatedMetal metal = timeline.metal();

  const std::filesystem::path out = options.out;
  const ResultPlace place(out);
  std::optional<WeatherPainter> painter;
  std::vector<std::string> files;
  Camera camera;
  // Kept until the end: a timeline that turns out to be wrong leaves an earlier run's results as they are.
  std::vector<std::pair<std::string, Image>> pictures;
  if (scene.picture.draw) {
    painter.emplace(surface, scene);
    camera = camera_of(surface.mesh(), scene.picture);
  }
  const std::vector<TimelineStep>& steps = scene.weathering.timeline;
  TimelineListener listener;
  listener.progress = [&](std::size_t k, double share) {
    progress.update((static_cast<double>(k) + share) / static_cast<double>(steps.size()),
                    fmt::format("{} ({} of {})", steps[k].op, k + 1, steps.size()));
    return !interrupted();
  };
  listener.after = [&](std::size_t k, const CoatedMetal& now, const TimelineRecord&) {
    if (!painter) return;
    pictures.emplace_back(fmt::format("{:02}-{}.png", k + 1, steps[k].op), painter->draw(now, camera));
  };
  progress.stage("weathering");
  const std::vector<TimelineRecord> records = timeline.run(metal, listener);
  const bool complete = records.size() == steps.size() && (records.empty() || records.back().report.complete);

  progress.stage("writing");
  place.clear();
  if (!pictures.empty()) pictures.emplace_back("picture.png", pictures.back().second);
  for (const auto& [name, picture] : pictures) {
    write_png(picture, out / name);
    files.push_back(name);
  }
  if (!options.no_cells) {
    write_weathered_cells(out / "cells.vtp", surface, metal);
    files.emplace_back("cells.vtp");
  }
  write_timeline_csv(out / "timeline.csv", records, metal, surface.owned_count());
  files.emplace_back("timeline.csv");
  write_scene(out / "run.toml", scene);
  files.emplace_back("run.toml");
  progress.finish();
  if (!complete)
    say("stopped in operation {} of {}; what was done until then is written\n", records.size(), steps.size());
  if (options.json || !options.quiet)
    report(scene, surface, records, files,
           std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), complete,
           options);
  return complete ? 0 : 130;
}
