#include "verdigris/picture/plot.hpp"

#include <cmath>
#include <cstdlib>

#include "verdigris/base/error.hpp"
#include "verdigris/io/write_png.hpp"

namespace verdigris {
namespace {

Plot two_curves() {
  Plot plot{"Growth of two kinds", "time (years)", "share of the surface (%)", {}, {}};
  plot.curves = {{"slow", {}}, {"fast", {}}};
  for (int k = 0; k <= 1000; ++k) {
    plot.curves[0].points.emplace_back(0.03 * k, 100.0 / (1.0 + std::exp(5.0 - 0.01 * k)));
    plot.curves[1].points.emplace_back(0.03 * k, std::min(100.0, 0.003 * k * k));
  }
  return plot;
}

std::size_t pixels_like(const Image& image, int r, int g, int b) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < image.rgba.size(); k += 4)
    count +=
        std::abs(image.rgba[k] - r) + std::abs(image.rgba[k + 1] - g) + std::abs(image.rgba[k + 2] - b) < 12;
  return count;
}

TEST(Plot, TicksAreRoundAndInside) {
  EXPECT_EQ(round_ticks(0.0, 1.0, 5), (std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
  EXPECT_EQ(round_ticks(-3.0, 950.0, 5), (std::vector<double>{0.0, 200.0, 400.0, 600.0, 800.0}));
  EXPECT_TRUE(round_ticks(1.0, 1.0, 5).empty());
  EXPECT_EQ(tick_text(0.25), "0.25");
  EXPECT_EQ(tick_text(220000.0), "220000");
  EXPECT_EQ(tick_text(2.5e6), "2.5e6");
  EXPECT_EQ(tick_text(0.0), "0");
}

TEST(Plot, DrawsEveryCurveInItsColour) {
  Plot plot = two_curves();
  const Image image = draw_plot(plot, 640, 400);
  EXPECT_GT(pixels_like(image, 178, 84, 38), 200u);
  EXPECT_GT(pixels_like(image, 22, 128, 112), 100u);
  plot.curves[0].colour = {200, 0, 0, 255};
  EXPECT_GT(pixels_like(draw_plot(plot, 640, 400), 200, 0, 0), 200u);
  EXPECT_EQ(image.rgba, draw_plot(two_curves(), 640, 400).rgba);
  if (const char* file = std::getenv("VERDIGRIS_PLOT")) {
    plot = two_curves();
    plot.marks = {{12.0, "90 % after 12 years"}};
    write_png(draw_plot(plot), file);
  }
}

TEST(Plot, HoldsOutAgainstOddData) {
  const double none = std::nan("");
  for (const bool logarithmic : {false, true}) {
    for (std::vector<glm::dvec2> points : {std::vector<glm::dvec2>{},
                                           {{1, 1}},
                                           {{0, 0}, {0, 0}},
                                           {{-5, 2}, {none, none}, {3, -1e300}},
                                           {{1e-12, 3e18}, {2e-12, 1}}}) {
      Plot plot{"", "", "", {{"curve", points}}, {{7.0, "mark"}}};
      plot.log_x = plot.log_y = logarithmic;
      EXPECT_EQ(draw_plot(plot, 320, 200).rgba.size(), 4u * 320u * 200u);
    }
  }
  EXPECT_EQ(draw_plot({}, 160, 120).width, 160);
  EXPECT_THROW(draw_plot({}, 100, 100), InputError);
}

}  // namespace
}  // namespace verdigris
