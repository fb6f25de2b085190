// Films by ffmpeg.
#include "verdigris/io/write_video.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include "verdigris/base/error.hpp"
#include "verdigris/io/write_png.hpp"

namespace verdigris {
namespace {

namespace fs = std::filesystem;

// A directory with a name that shells and printf would trip over.
class Frames {
 public:
  Frames() : path(fs::temp_directory_path() / fmt::format("verdigris %d 'f' {}", ::getpid())) {
    fs::create_directories(path);
  }
  ~Frames() { fs::remove_all(path); }
  std::vector<fs::path> draw(int count, int width, int height) const {
    std::vector<fs::path> files;
    for (int k = 0; k < count; ++k) {
      Image image{width, height, {}};
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          for (const int c : {(x + 3 * k) % 256, y % 256, 90, 255})
            image.rgba.push_back(static_cast<std::uint8_t>(c));
      files.push_back(path / fmt::format("{:05}.png", k));
      write_png(image, files.back());
    }
    return files;
  }
  fs::path path;
};

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Video : public testing::Test {
 protected:
  void SetUp() override {
    try {
      ffmpeg = find_ffmpeg();
    } catch (const InputError&) {
      GTEST_SKIP() << "there is no ffmpeg";
    }
  }
  std::string ffmpeg;
  Frames frames;
};

TEST_F(Video, IsAnMp4AndTheSameEachTime) {
  const auto pictures = frames.draw(20, 97, 61);
  std::size_t last = 0;
  const auto see = [&](std::size_t done) {
    last = done;
    return true;
  };
  EXPECT_TRUE(write_video(ffmpeg, pictures, 24.0, frames.path / "a.mp4", see));
  EXPECT_TRUE(write_video(ffmpeg, pictures, 24.0, frames.path / "b.mp4"));
  EXPECT_EQ(last, 20u);
  const std::string film = bytes_of(frames.path / "a.mp4");
  EXPECT_EQ(film.substr(4, 4), "ftyp");
  EXPECT_NE(film.find("avc1"), std::string::npos);
  EXPECT_EQ(film, bytes_of(frames.path / "b.mp4"));
}

TEST_F(Video, LeavesNothingWhenStoppedOrRefused) {
  const auto pictures = frames.draw(30, 64, 64);
  const fs::path film = frames.path / "a.mp4";
  EXPECT_FALSE(write_video(ffmpeg, pictures, 24.0, film, [](std::size_t done) { return done < 9; }));
  const auto refused = [&] {
    EXPECT_THROW(write_video(ffmpeg, pictures, 24.0, film), InputError);
    std::size_t others = 0;
    for (const auto& entry : fs::directory_iterator(frames.path))
      others += entry.path().extension() != ".png";
    EXPECT_EQ(others, 0u);
  };
  // Cut off, empty, no picture, not there.
  const std::string whole = bytes_of(pictures[12]);
  for (const std::string& damaged :
       {whole.substr(0, whole.size() / 2), std::string(), std::string("hello")}) {
    std::ofstream(pictures[12], std::ios::binary) << damaged;
    refused();
  }
  fs::remove(pictures[12]);
  refused();
}

TEST(NoFfmpeg, IsSaidWithARemedy) {
  ::setenv("VERDIGRIS_FFMPEG", "/nowhere/ffmpeg", 1);
  EXPECT_THROW(find_ffmpeg(), InputError);
  ::setenv("VERDIGRIS_FFMPEG", "false", 1);
  EXPECT_THROW(find_ffmpeg(), InputError);
  ::unsetenv("VERDIGRIS_FFMPEG");
}

}  // namespace
}  // namespace verdigris
