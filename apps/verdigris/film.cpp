#include "film.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "result_place.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/read_image.hpp"
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

// What a crash of the machine or another hand has damaged is drawn again.
bool is_whole(const fs::path& file, const PicturePlan& plan) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return false;
  try {
    const GreyImage image = read_grey_image(file);
    return image.width == plan.width && image.height == plan.height;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

Film::Film(fs::path out, const Scene& scene, std::size_t frames, bool resume)
    : directory_(out / "frames"), there_(frames, false), check_(frames) {
  if (resume) check_same_scene(out / "run.toml", scene);
  make_directory(directory_);
  remove_remains();
  if (!resume) {
    write_scene(out / "run.toml", scene);
    return;
  }
  for (std::size_t k = 0; k < frames; ++k) {
    there_[k] = is_whole(file_of(k), scene.picture);
    kept_ += there_[k];
  }
  // The last of the first run of frames that are there.
  const auto first = std::find(there_.begin(), there_.end(), true);
  if (first != there_.end())
    check_ = static_cast<std::size_t>(std::find(first, there_.end(), false) - there_.begin()) - 1;
}

// What processes that were killed left half written.
void Film::remove_remains() const {
  std::vector<std::string> names;
  std::error_code ignored;
  for (fs::directory_iterator it(directory_, ignored), end; !ignored && it != end; it.increment(ignored)) {
    const std::string name = it->path().filename().string();
    if (name.size() > 9 && is_frame(name.substr(0, 9))) names.push_back(name.substr(0, 9));
  }
  for (const std::string& name : names) remove_abandoned(directory_ / name);
}

Film::~Film() {
  if (writing_.valid()) writing_.wait();
}

fs::path Film::file_of(std::size_t k) const {
  return directory_ / fmt::format("{:05}.png", k);
}

std::vector<fs::path> Film::files() const {
  std::vector<fs::path> files;
  for (std::size_t k = 0; k < there_.size(); ++k) files.push_back(file_of(k));
  return files;
}

void Film::check(std::size_t k, const Image& image) const {
  const fs::path again = fs::temp_directory_path() / fmt::format("verdigris-{}.png", ::getpid());
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
