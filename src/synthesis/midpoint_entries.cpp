#include "entries.hpp"
#include "grid_field.hpp"
#include "verdigris/synthesis/midpoint.hpp"

namespace verdigris {

namespace {

struct MidpointParameters {
  double h = 0.8;
  int levels = 9;
  std::string scheme = "squares";
  int tileable = 1;

  template <typename V>
  void parameters(V&& v) {
    v("h", h, 0.0, 1.0, "1", "Hurst exponent: displacements fall by 2^-h a level; high is smooth");
    v("levels", levels, 1, 12, "1", "how often the grid is halved: 2^levels + 1 points along a side");
    v("scheme", scheme, {"midpoints", "additions", "squares"},
      "midpoints keep early points and their creases, additions displace all points at each level, squares "
      "keep no point");
    v("tileable", tileable, 0, 1, "1", "1: repeats without a seam; 0: mirrored beyond the unit square");
  }
  MidpointOptions options(std::uint64_t seed) const {
    return {levels, h,
            scheme == "midpoints"   ? MidpointScheme::midpoints
            : scheme == "additions" ? MidpointScheme::additions
                                    : MidpointScheme::squares,
            tileable != 0, seed};
  }
  synthesis::Beyond beyond() const {
    return tileable != 0 ? synthesis::Beyond::repeat : synthesis::Beyond::mirror;
  }
};

struct MidpointLine : MidpointParameters {
  static constexpr const char *name = "midpoint", *summary = "midpoint displacement along x";
  static constexpr int dimension = 1;
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const {
    const std::vector<double> line = midpoint_line(options(seed));
    return std::make_unique<synthesis::GridField>(synthesis::to_unit_range(line),
                                                  static_cast<int>(line.size()), 1, beyond());
  }
};

struct DiamondSquarePrimitive : MidpointParameters {
  static constexpr const char *name = "diamond-square", *summary = "midpoint displacement over the plane";
  static constexpr int dimension = 2;
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const {
    const HeightGrid grid = diamond_square(options(seed));
    return std::make_unique<synthesis::GridField>(synthesis::to_unit_range(grid.heights), grid.side,
                                                  grid.side, beyond());
  }
};

}  // namespace

void add_midpoint(PrimitiveCatalogue& catalogue) {
  catalogue.add(primitive_entry<MidpointLine>());
  catalogue.add(primitive_entry<DiamondSquarePrimitive>());
}

}  // namespace verdigris
