// What is written over frames.
#include "verdigris/picture/overlay.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace verdigris {
namespace {

Image grey(int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height), 128)};
  for (std::size_t k = 3; k < image.rgba.size(); k += 4) image.rgba[k] = 255;
  return image;
}

// Pixels that differ, and whether all of them are in the lower left quarter.
int changed(const Image& a, const Image& b, bool& in_corner) {
  int count = 0;
  in_corner = true;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const auto k = 4 * static_cast<std::size_t>(y * a.width + x);
      if (a.rgba[k] == b.rgba[k] && a.rgba[k + 1] == b.rgba[k + 1] && a.rgba[k + 2] == b.rgba[k + 2])
        continue;
      ++count;
      in_corner = in_corner && x < a.width / 2 && y > a.height / 2;
    }
  return count;
}

TEST(Overlay, IsWrittenIntoTheCornerAndGrows) {
  const std::vector<glm::dvec2> points{{0, 0}, {5, 40}, {10, 90}};
  const Image clean = grey(640, 360);
  bool in_corner = false;
  Image early = clean, late = clean, again = clean;
  draw_overlay(early, {"1.0 years", "8 % corroded", points, 1.0});
  draw_overlay(late, {"9.0 years", "82 % corroded", points, 9.0});
  draw_overlay(again, {"9.0 years", "82 % corroded", points, 9.0});
  EXPECT_EQ(late.rgba, again.rgba);
  EXPECT_GT(changed(clean, early, in_corner), 5000);
  EXPECT_TRUE(in_corner);
  // More of the curve is green.
  const auto green = [](const Image& image) {
    int count = 0;
    for (std::size_t k = 0; k < image.rgba.size(); k += 4) count += image.rgba[k + 1] > image.rgba[k] + 60;
    return count;
  };
  EXPECT_GT(green(late), 2 * green(early));
}

TEST(Overlay, LeavesThumbnailsAlone) {
  Image image = grey(100, 80);
  const Image clean = image;
  draw_overlay(image, {"1 year", "", {}, 0.0});
  EXPECT_EQ(image.rgba, clean.rgba);
  Image narrow = grey(30, 200);
  draw_overlay(narrow, {"1000 years", "", {}, 0.0});  // wider than the picture
  bool ignored = false;
  EXPECT_GT(changed(grey(30, 200), narrow, ignored), 0);
}

}  // namespace
}  // namespace verdigris
