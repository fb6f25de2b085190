// From a material and the ages of cells to what is drawn.
#include "verdigris/picture/patina.hpp"

#include <cmath>

#include "verdigris/base/error.hpp"
#include "verdigris/io/read_material.hpp"

namespace verdigris {
namespace {

TEST(Patina, CellsHoldTheThicknessOfTheirAge) {
  const Material copper = find_material("copper");
  const LayerStack looks = looks_of(copper);
  ASSERT_EQ(looks.layers.size(), 2u);
  const std::vector<std::int32_t> arrivals{-1, 0, 10, 99, 500};
  const std::vector<std::uint8_t> rates{255, 255, 255, 51, 255};
  const PatinaAges ages{arrivals, rates, ExposureClass::C4, 0.25, 30.0};  // now: step 120
  const auto cells = patina_cells(copper, ages);
  const auto heights = patina_heights(copper, ages);
  for (std::size_t k = 0; k < arrivals.size(); ++k) {
    const bool sound = arrivals[k] < 0 || arrivals[k] > 120;
    const double years = sound ? -1.0 : 30.0 - 0.25 * arrivals[k], rate = rates[k] / 255.0;
    double height = sound ? 0.0 : -metal_loss(copper, ExposureClass::C4, years, rate);
    for (std::size_t l = 0; l < 2; ++l) {
      const double t = layer_thickness(copper.layers[1 - l], ExposureClass::C4, years, rate);
      EXPECT_EQ(cells[k].depth[l], LayerCell::packed(optical_depth(looks.layers[l], static_cast<float>(t))));
      height += t;
    }
    EXPECT_NEAR(heights[k], height, 1e-4);
    EXPECT_EQ(cells[k].present, 255);
  }
  EXPECT_EQ(cells[0].depth[0], 0);
  EXPECT_GT(cells[1].depth[0], 0);
}

TEST(Patina, AgesBetweenStepsCount) {
  const Material copper = find_material("copper");
  const std::vector<std::int32_t> arrivals{2};
  const auto at = [&](double now) {
    return patina_heights(copper, {arrivals, {}, ExposureClass::C3, 1.0, now})[0];
  };
  EXPECT_EQ(at(1.9), 0.0f);
  EXPECT_NEAR(at(4.5),
              layer_thickness(copper.layers[0], ExposureClass::C3, 2.5) +
                  layer_thickness(copper.layers[1], ExposureClass::C3, 2.5) -
                  metal_loss(copper, ExposureClass::C3, 2.5),
              1e-4);
}

TEST(Patina, MetalGoesAndPaintIsThereFromTheStart) {
  Material steel = find_material("steel");
  steel.thickness = 100.0;
  const std::vector<std::int32_t> arrivals{-1, 0};
  const double gone = metal_lifetime(steel, ExposureClass::C5);
  const auto cells = patina_cells(steel, {arrivals, {}, ExposureClass::C5, 0.01, gone + 0.1});
  EXPECT_EQ(cells[0].depth[0], 65535);  // paint
  EXPECT_EQ(cells[0].present, 255);
  EXPECT_EQ(cells[1].present, 0);
}

TEST(Patina, TooManyLayersForAPictureAreRefused) {
  Material material = find_material("copper");
  material.layers.resize(most_layers + 1);
  EXPECT_THROW(looks_of(material), InputError);
}

}  // namespace
}  // namespace verdigris
