#include "verdigris/io/write_video.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "child_process.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"

namespace verdigris {

using io::ChildProcess;

std::string find_ffmpeg() {
  const char* const given = std::getenv("VERDIGRIS_FFMPEG");
  const std::string name = given != nullptr && *given != '\0' ? given : "ffmpeg";
  try {
    ChildProcess version({name, "-version"});
    while (version.line()) {
    }
    if (version.wait() == 0) return name;
  } catch (const std::system_error&) {
    // Said below.
  }
  throw InputError(name, "is not there or does not run, and films need it",
                   "install it (Debian: apt install ffmpeg), set VERDIGRIS_FFMPEG, or draw only the frames "
                   "with --no-video");
}

bool write_video(const std::string& ffmpeg, const std::filesystem::path& frames, const std::string& pattern,
                 std::size_t count, double rate, const std::filesystem::path& file,
                 const std::function<bool(std::size_t done)>& progress) {
  ReplaceFile out(std::filesystem::absolute(file));
  // sRGB pictures as what players take for granted: BT.709 of limited range. A fixed number of threads, for
  // the encoder's choices depend on it.
  const std::vector<std::string> command{
      ffmpeg,
      "-hide_banner",
      "-nostdin",
      "-v",
      "error",
      "-progress",
      "pipe:1",
      "-y",
      "-framerate",
      fmt::format("{:.17g}", rate),
      "-start_number",
      "0",
      "-i",
      pattern,
      "-frames:v",
      std::to_string(count),
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
    ChildProcess child(command, frames);
    bool wanted = true;
    while (const auto line = child.line()) {
      constexpr std::string_view key = "frame=";
      if (!line->starts_with(key)) continue;
      std::size_t done = 0;
      std::from_chars(line->data() + key.size(), line->data() + line->size(), done);
      if (wanted && progress && !progress(done)) {
        wanted = false;
        child.stop();
      }
    }
    const int status = child.wait();
    if (!wanted) return false;
    if (status != 0) {
      std::string said = child.errors();
      while (!said.empty() && said.back() == '\n') said.pop_back();
      throw InputError(file.string(), fmt::format("ffmpeg ended with status {}: {}", status, said),
                       "see what it says; --no-video draws only the frames");
    }
  } catch (const std::system_error& error) {
    throw InputError(ffmpeg, error.what(), "install ffmpeg, or draw only the frames with --no-video");
  }
  out.commit();
  return true;
}

}  // namespace verdigris
