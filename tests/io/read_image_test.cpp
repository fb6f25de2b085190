// Pictures in.
#include "verdigris/io/read_image.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "verdigris/base/error.hpp"
#include "verdigris/io/write_png.hpp"

namespace verdigris {
namespace {

namespace fs = std::filesystem;

class ReadImage : public testing::Test {
 protected:
  ~ReadImage() override {
    std::error_code ignored;
    fs::remove(file, ignored);
  }
  fs::path file = fs::temp_directory_path() / fmt::format("verdigris-{}-image.png", ::getpid());
};

TEST_F(ReadImage, GivesLuminanceOfEightBits) {
  const Image image{3, 2, {255, 0,   0,   255, 0, 255, 0, 255, 0,   0,   255, 255,
                           255, 255, 255, 255, 0, 0,   0, 255, 128, 128, 128, 7}};
  write_png(image, file);
  const GreyImage grey = read_grey_image(file);
  ASSERT_EQ(grey.width, 3);
  ASSERT_EQ(grey.height, 2);
  const double expected[] = {0.2126, 0.7152, 0.0722, 1.0, 0.0, 128.0 / 255.0};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(grey.levels[k] / 65535.0, expected[k], 1e-4) << k;
}

TEST_F(ReadImage, GivesSixteenBitsAsTheyAre) {
  const GreyImage image{2, 2, {0, 1, 40000, 65535}};
  write_grey_png(image, file);
  EXPECT_EQ(read_grey_image(file).levels, image.levels);
}

TEST_F(ReadImage, RefusesWhatIsNoImage) {
  EXPECT_THROW(read_grey_image(file), InputError);
  std::ofstream(file) << "no picture";
  EXPECT_THROW(read_grey_image(file), InputError);
}

}  // namespace
}  // namespace verdigris
