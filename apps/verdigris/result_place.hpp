#pragma once
// The directory that a run writes its results into.

#include <filesystem>
#include <string_view>

#include "verdigris/io/scene.hpp"

/// Whether a file is named as frames of films are: 00012.png.
bool is_frame(std::string_view name);

/// Refuses what a scene reads when it lies where results go into `out`, and would be lost; and names that are
/// not UTF-8: scenes are TOML, and a run with another name could not be repeated. Throws InputError.
void check_inputs(const verdigris::Scene& scene, const std::filesystem::path& out);

/// Makes the directory and takes away what ended runs left half written; takes the directory away again when
/// nothing came to be in it.
class ResultPlace {
 public:
  explicit ResultPlace(std::filesystem::path path);
  ~ResultPlace();
  ResultPlace(const ResultPlace&) = delete;
  ResultPlace& operator=(const ResultPlace&) = delete;

  /// Removes what an earlier run left there and this one may not write, pictures of ages and operations and
  /// frames of films too: it would not be of these cells. Stay: a checkpoint, run.toml, which may be the very
  /// scene that runs and is replaced in the end, and pictures of masks. Throws InputError when that cannot be
  /// done.
  void clear() const;

 private:
  std::filesystem::path path_;
  bool made_;
};
