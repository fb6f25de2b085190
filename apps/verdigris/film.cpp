#include "film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"
#include "verdigris/io/write_png.hpp"

using namespace verdigris;

namespace fs = std::filesystem;

namespace {

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void check_same_scene(const fs::path& file, const Scene& scene) {
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    throw InputError(file.string(), "is not there: there is no film to go on with",
                     "leave --resume out, or name the directory of the film with --out");
  if (bytes_of(file) != scene_text(file, scene))
    throw InputError(file.string(), "is of another film than this command makes",
                     "give the options and the scene it was begun with, or leave --resume out");
}

// Of frames and their remains: five digits first.
bool is_frame(const std::string& name) {
  return name.size() >= 9 && name.find_first_not_of("0123456789") == 5 && name.compare(5, 4, ".png") == 0;
}

}  // namespace

Film::Film(fs::path out, const Scene& scene, std::size_t frames, bool resume)
    : directory_(out / "frames"), there_(frames, false), check_(frames) {
  if (resume) check_same_scene(out / "run.toml", scene);
  make_directory(directory_);
  std::error_code ignored;
  for (fs::directory_iterator it(directory_, ignored), end; !ignored && it != end; it.increment(ignored)) {
    const std::string name = it->path().filename().string();
    if (is_frame(name) && (!resume || name.size() > 9)) fs::remove(it->path(), ignored);
  }
  fs::remove(out / "animation.mp4", ignored);
  if (!resume) write_scene(out / "run.toml", scene);
  for (std::size_t k = 0; k < frames; ++k) {
    there_[k] = fs::exists(file_of(k), ignored);
    kept_ += there_[k];
  }
  const auto missing = std::find(there_.begin(), there_.end(), false);
  if (kept_ > 0)
    check_ = missing == there_.begin() || missing == there_.end()
                 ? static_cast<std::size_t>(std::find(there_.begin(), there_.end(), true) - there_.begin())
                 : static_cast<std::size_t>(missing - there_.begin()) - 1;
}

Film::~Film() {
  if (writing_.valid()) writing_.wait();
}

fs::path Film::file_of(std::size_t k) const {
  return directory_ / fmt::format("{:05}.png", k);
}

void Film::check(std::size_t k, const Image& image) const {
  const fs::path again = directory_ / "again.png";
  write_png(image, again);
  const bool same = bytes_of(again) == bytes_of(file_of(k));
  std::error_code ignored;
  fs::remove(again, ignored);
  if (!same)
    throw InputError(
        file_of(k).string(), "is not what this scene looks like now",
        "a model, mask or material has changed, or the program or its OpenGL: leave --resume out");
}

void Film::add(std::size_t k, Image image) {
  finish();
  writing_ = std::async(std::launch::async,
                        [file = file_of(k), image = std::move(image)] { write_png(image, file); });
}

void Film::finish() {
  if (writing_.valid()) writing_.get();
}
