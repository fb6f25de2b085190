#include "result_place.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"

using namespace verdigris;

namespace {

constexpr const char* checkpoint_name = "checkpoint.vgc";
constexpr std::array files{"cells.vtp",     "regions.csv", "curve.csv",    "statistics.csv", "timeline.csv",
                           "spots.csv",     "share.png",   "loss.png",     "spots.png",      "picture.png",
                           checkpoint_name, "run.toml",    "animation.mp4"};

// Pictures of an earlier run, of ages and of operations: patina-0012.500y.png, 03-age.png.
bool is_numbered(std::string_view name) {
  if (!name.ends_with(".png")) return false;
  return name.starts_with("patina-") ||
         (name.size() > 7 && name.find_first_not_of("0123456789") == 2 && name[2] == '-');
}

}  // namespace

void check_utf8(const std::filesystem::path& path) {
  try {
    static_cast<void>(nlohmann::json(path.string()).dump());
  } catch (const nlohmann::json::type_error&) {
    throw InputError("file name", "it is not UTF-8, and run.toml could not hold it", "rename the file");
  }
}

ResultPlace::ResultPlace(std::filesystem::path path)
    : path_(std::move(path)), made_(!std::filesystem::exists(path_)) {
  make_directory(path_);
  for (const char* name : files) remove_abandoned(path_ / name);
}

ResultPlace::~ResultPlace() {
  std::error_code not_empty;
  if (made_) std::filesystem::remove(path_, not_empty);
}

void ResultPlace::clear() const {
  std::error_code ignored;
  for (const char* name : files)
    if (name != checkpoint_name) std::filesystem::remove(path_ / name, ignored);
  for (std::filesystem::directory_iterator it(path_, ignored), end; !ignored && it != end;
       it.increment(ignored))
    if (is_numbered(it->path().filename().string())) std::filesystem::remove(it->path(), ignored);
}
