// The catalogue of primitives: every entry can be made, describes itself, and refuses what it does not know.

#include "verdigris/synthesis/primitive_catalogue.hpp"

#include <gtest/gtest.h>

#include <set>

#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

struct Slope final : ScalarField {
  explicit Slope(double k) : by(k) {}
  ValueRange range() const override { return {0.0f, 1.0f, false}; }
  void compute(const Points& points, double, std::span<float> out) const override {
    for (std::size_t k = 0; k < points.size(); ++k) out[k] = static_cast<float>(by * points.x[k]);
  }
  double by;
};

struct SlopePrimitive {
  static constexpr const char *name = "slope", *summary = "rises along x";
  static constexpr int dimension = 1;
  double by = 1.0;
  template <typename V>
  void parameters(V&& v) {
    v("by", by, 0.0, 10.0, "1", "how fast it rises");
  }
  std::unique_ptr<ScalarField> make(std::uint64_t) const { return std::make_unique<Slope>(by); }
};

TEST(PrimitiveCatalogue, TakesPrimitivesFromOutside) {
  PrimitiveCatalogue catalogue = builtin_primitives();
  catalogue.add(primitive_entry<SlopePrimitive>());
  const auto field = catalogue.find("slope").create({{"by", 2.0}}, 1);
  EXPECT_EQ(field->at({0.25, 0.0, 0.0, 0.0}), 0.5f);
  EXPECT_THROW(catalogue.find("slope").create({{"by", 20.0}}, 1), InputError);
  EXPECT_THROW(catalogue.find("slop"), InputError);
  EXPECT_THROW(catalogue.add(primitive_entry<SlopePrimitive>()), std::invalid_argument);
}

TEST(PrimitiveCatalogue, RefusesArraysOfDifferentLengths) {
  const Slope field(1.0);
  const std::vector<double> two(2), three(3);
  std::vector<float> out(2);
  EXPECT_THROW(field.evaluate({.x = three}, 0.0, out), std::invalid_argument);
  EXPECT_THROW(field.evaluate({.x = two, .y = three}, 0.0, out), std::invalid_argument);
  EXPECT_NO_THROW(field.evaluate({.x = two, .y = two}, 0.0, out));
}

TEST(PrimitiveCatalogue, EntriesDescribeThemselvesAndCanBeMade) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  std::set<std::string> names;
  for (const PrimitiveEntry& entry : catalogue.entries()) {
    SCOPED_TRACE(entry.name);
    EXPECT_TRUE(names.insert(entry.name).second);
    EXPECT_FALSE(entry.summary.empty());
    EXPECT_TRUE(entry.dimension >= 1 && entry.dimension <= 4);
    for (const ParameterInfo& p : entry.parameters) EXPECT_FALSE(p.help.empty()) << p.name;
    const auto field = entry.create({}, 7);
    ASSERT_NE(field, nullptr);
    EXPECT_LT(field->range().least, field->range().greatest);
    EXPECT_THROW(entry.create({{"no-such", 1.0}}, 7), InputError);
  }
}

}  // namespace
}  // namespace verdigris
