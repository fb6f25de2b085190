#pragma once
// Pictures as a film, by the program ffmpeg.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace verdigris {

/// The ffmpeg that is used: of the variable VERDIGRIS_FFMPEG, else found on the PATH. Throws InputError when
/// there is none that runs and encodes H.264.
std::string find_ffmpeg();

/// Encodes `pictures`, PNG files of one size, in order into `file`: an MP4 of H.264 at `rate` pictures a
/// second that plays anywhere; sides of odd length get a row or column more. The same pictures give the same
/// bytes from one ffmpeg, whatever the machine's number of cores. Written aside and renamed. `progress` gets
/// the pictures handed over; false: stop, nothing is written. Returns whether it was finished. Throws
/// InputError for pictures that cannot be read or are damaged, with what ffmpeg says.
bool write_video(const std::string& ffmpeg, const std::vector<std::filesystem::path>& pictures, double rate,
                 const std::filesystem::path& file,
                 const std::function<bool(std::size_t done)>& progress = {});

}  // namespace verdigris
