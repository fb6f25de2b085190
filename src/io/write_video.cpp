#include "verdigris/io/write_video.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "child_process.hpp"
#include "file_bytes.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"

namespace verdigris {

using io::ChildProcess;

namespace {

// The last number of pictures that ffmpeg said it has encoded.
std::size_t encoded(std::string_view said) {
  constexpr std::string_view key = "frame=";
  std::size_t count = 0;
  if (const auto at = said.rfind(key); at != std::string_view::npos)
    std::from_chars(said.data() + at + key.size(), said.data() + said.size(), count);
  return count;
}

}  // namespace

std::string find_ffmpeg() {
  const char* const given = std::getenv("VERDIGRIS_FFMPEG");
  const std::string name = given != nullptr && *given != '\0' ? given : "ffmpeg";
  try {
    ChildProcess encoders({name, "-hide_banner", "-encoders"});
    encoders.end_input();
    if (encoders.wait() == 0 && encoders.output().find("libx264") != std::string::npos) return name;
  } catch (const std::system_error&) {
    // Said below.
  }
  throw InputError(name, "is not there, does not run or has no libx264, and films need it",
                   "install it (Debian: apt install ffmpeg), or set VERDIGRIS_FFMPEG");
}

bool write_video(const std::string& ffmpeg, const std::vector<std::filesystem::path>& pictures, double rate,
                 const std::filesystem::path& file, const std::function<bool(std::size_t done)>& progress) {
  ReplaceFile out(std::filesystem::absolute(file));
  // sRGB pictures as what players take for granted: BT.709 of limited range. A fixed number of threads, for
  // the encoder's choices depend on it. Pictures come through a pipe: ffmpeg ends when this program does.
  const std::vector<std::string> command{
      ffmpeg,
      "-hide_banner",
      "-v",
      "error",
      "-xerror",
      "-nostats",
      "-progress",
      "pipe:1",
      "-y",
      "-f",
      "image2pipe",
      "-c:v",
      "png",
      "-framerate",
      fmt::format("{:.17g}", rate),
      "-i",
      "pipe:0",
      "-vf",
      "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
      "-c:v",
      "libx264",
      "-preset",
      "medium",
      "-crf",
      "17",
      "-threads",
      "4",
      "-colorspace",
      "bt709",
      "-color_primaries",
      "bt709",
      "-color_trc",
      "iec61966-2-1",
      "-color_range",
      "tv",
      "-fflags",
      "+bitexact",
      "-flags:v",
      "+bitexact",
      "-movflags",
      "+faststart",
      "-f",
      "mp4",
      "file:" + out.aside().string()};
  try {
    ChildProcess child(command);
    for (std::size_t k = 0; k < pictures.size(); ++k) {
      const io::FileBytes picture = io::read_file(pictures[k]);
      if (!child.write(picture.view())) break;  // it has ended: said below
      if (progress && !progress(k + 1)) return false;
    }
    child.end_input();
    const int status = child.wait();
    const std::size_t count = encoded(child.output());
    std::string said = child.errors();
    while (said.ends_with('\n')) said.pop_back();
    if (said.empty()) said = "it does not say why";
    if (status != 0)
      throw InputError(file.string(), fmt::format("ffmpeg ended with status {}: {}", status, said),
                       "see what it says");
    if (count != pictures.size())
      throw InputError(file.string(),
                       fmt::format("ffmpeg took {} of {} pictures: {}", count, pictures.size(), said),
                       "look for damaged pictures, and remove them");
  } catch (const std::system_error& error) {
    throw InputError(ffmpeg, error.what(), "install ffmpeg");
  }
  out.commit();
  return true;
}

}  // namespace verdigris
