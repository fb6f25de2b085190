#include "result_place.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"
#include "verdigris/weathering/operators.hpp"

using namespace verdigris;

namespace {

constexpr std::string_view checkpoint_name = "checkpoint.vgc", scene_name = "run.toml";
constexpr std::array<std::string_view, 13> files{
    "cells.vtp", "regions.csv", "curve.csv",   "statistics.csv", "timeline.csv", "spots.csv",    "share.png",
    "loss.png",  "spots.png",   "picture.png", checkpoint_name,  scene_name,     "animation.mp4"};

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789.") == std::string_view::npos;
}

// Pictures of ages and of operations: patina-012.500y.png, 03-age.png.
bool is_numbered(std::string_view name) {
  if (!name.ends_with(".png")) return false;
  name.remove_suffix(4);
  if (name.starts_with("patina-") && name.ends_with("y")) return is_number(name.substr(7, name.size() - 8));
  if (name.size() < 4 || name[2] != '-' || !is_number(name.substr(0, 2))) return false;
  static const OperatorCatalogue operators = builtin_operators();
  return std::any_of(operators.entries().begin(), operators.entries().end(),
                     [&](const OperatorEntry& entry) { return entry.name == name.substr(3); });
}

void check_utf8(const std::filesystem::path& path) {
  try {
    static_cast<void>(nlohmann::json(path.string()).dump());
  } catch (const nlohmann::json::type_error&) {
    throw InputError("file name", "it is not UTF-8, and run.toml could not hold it", "rename the file");
  }
}

}  // namespace

bool is_frame(std::string_view name) {
  return name.size() == 9 && name.find_first_not_of("0123456789") == 5 && name.substr(5) == ".png";
}

void check_inputs(const Scene& scene, const std::filesystem::path& out) {
  std::vector<std::filesystem::path> inputs{scene.mesh, scene.barrier.mask};
  for (const MaskPlan& mask : scene.masks) inputs.insert(inputs.end(), {mask.file, mask.image});
  for (const std::string& material : {scene.corrosion.material, scene.weathering.material})
    if (material.ends_with(".toml")) inputs.emplace_back(material);
  const auto place = std::filesystem::weakly_canonical(out), frames = place / "frames";
  for (const std::filesystem::path& input : inputs) {
    if (input.empty()) continue;
    check_utf8(input);
    const auto file = std::filesystem::weakly_canonical(input);
    const std::string name = file.filename().string();
    const bool is_result = std::find(files.begin(), files.end(), name) != files.end() || is_numbered(name);
    if ((file.parent_path() == place && is_result) || (file.parent_path() == frames && is_frame(name)))
      throw InputError(input.string(), "is read, and results of that name go into the same directory",
                       "give another directory, or rename the file");
  }
}

ResultPlace::ResultPlace(std::filesystem::path path)
    : path_(std::move(path)), made_(!std::filesystem::exists(path_)) {
  make_directory(path_);
  for (const std::string_view name : files) {
    if (std::filesystem::is_directory(path_ / name))
      throw InputError((path_ / name).string(), "is a directory, and results go into files of such names",
                       "choose another directory, or rename this one");
    remove_abandoned(path_ / name);
  }
}

ResultPlace::~ResultPlace() {
  std::error_code not_empty;
  if (made_) std::filesystem::remove(path_, not_empty);
}

void ResultPlace::clear() const {
  std::error_code ignored;
  std::vector<std::filesystem::path> earlier;
  for (const std::string_view name : files)
    if (name != checkpoint_name && name != scene_name) std::filesystem::remove(path_ / name, ignored);
  for (std::filesystem::directory_iterator it(path_, ignored), end; !ignored && it != end;
       it.increment(ignored))
    if (is_numbered(it->path().filename().string())) earlier.push_back(it->path());
  for (std::filesystem::directory_iterator it(path_ / "frames", ignored), end; !ignored && it != end;
       it.increment(ignored))
    if (is_frame(it->path().filename().string())) earlier.push_back(it->path());
  for (const std::filesystem::path& file : earlier)
    if (!std::filesystem::remove(file, ignored))
      throw InputError(file.string(), "is of an earlier run and cannot be removed",
                       "choose another directory");
}
