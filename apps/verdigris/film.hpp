#pragma once
// The frames of a film on disk: each whole or not there, so that a film that was stopped goes on.

#include <cstddef>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "verdigris/io/scene.hpp"
#include "verdigris/picture/image.hpp"

class Film {
 public:
  /// Frames lie in `out`/frames; `out`/run.toml says what they are of. With `resume` those that are there
  /// count; without it there must be none (see ResultPlace::clear). Throws InputError when there is nothing
  /// to resume, or when it is of another scene.
  Film(std::filesystem::path out, const verdigris::Scene& scene, std::size_t frames, bool resume);
  /// Waits for what is being written.
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// Whether frame k is there already.
  bool has(std::size_t k) const { return there_[k]; }
  std::size_t kept() const { return kept_; }
  /// The frame to be drawn again to see that the old ones are of this film: the last of the first that are
  /// there in a row. The number of frames when none is there.
  std::size_t to_check() const { return check_; }
  /// Throws InputError when frame k as it is on disk is another picture.
  void check(std::size_t k, const verdigris::Image& image) const;
  /// Writes frame k; another thread does it while the next is drawn.
  void add(std::size_t k, verdigris::Image image);
  /// Waits until all are written. Throws InputError when one could not be.
  void finish();

  const std::filesystem::path& directory() const { return directory_; }
  /// [frame] where it is or will be.
  std::vector<std::filesystem::path> files() const;

 private:
  std::filesystem::path file_of(std::size_t k) const;
  void remove_remains() const;

  std::filesystem::path directory_;
  std::vector<bool> there_;
  std::size_t kept_ = 0, check_;
  std::future<void> writing_;
};
