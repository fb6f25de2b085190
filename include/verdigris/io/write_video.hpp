#pragma once
// Numbered pictures as a film, by the program ffmpeg.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace verdigris {

/// The ffmpeg that is used: of the variable VERDIGRIS_FFMPEG, else found on the PATH. Throws InputError when
/// there is none that runs.
std::string find_ffmpeg();

/// Encodes pictures 0 .. count - 1, `frames`/`pattern` (as of printf: "%05d.png"), into `file`, an MP4 of
/// H.264 at `rate` pictures a second that plays anywhere; sides of odd length get a row or column more. The
/// same pictures give the same bytes from one ffmpeg, whatever the machine's number of cores. Written aside
/// and renamed. `progress` gets the pictures done; false: stop, nothing is written. Returns whether it was
/// finished. Throws InputError with what ffmpeg says.
bool write_video(const std::string& ffmpeg, const std::filesystem::path& frames, const std::string& pattern,
                 std::size_t count, double rate, const std::filesystem::path& file,
                 const std::function<bool(std::size_t done)>& progress = {});

}  // namespace verdigris
