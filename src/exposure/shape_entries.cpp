#include <limits>

#include "mask_entries.hpp"
#include "verdigris/exposure/curvature.hpp"
#include "verdigris/exposure/lie.hpp"
#include "verdigris/exposure/line_distance.hpp"
#include "verdigris/exposure/model_colours.hpp"

namespace verdigris {

namespace {

struct UpMask {
  std::string up = "y";

  template <typename V>
  void parameters(V&& v) {
    v("up", up, {}, "which way is up: an axis or three numbers");
  }
};

struct HeightMask : UpMask {
  static constexpr const char *name = "height", *unit = "1",
                              *summary = "height: 0 at the lowest point of the model, 1 at the highest";
  Field<float> make(const Surface& surface, std::uint64_t) const {
    return height_mask(surface, parse_direction(up, "height.up"));
  }
};

struct SlopeMask : UpMask {
  static constexpr const char *name = "slope", *unit = "1",
                              *summary = "slope in right angles: 0 level, 1 a wall, 2 a ceiling";
  Field<float> make(const Surface& surface, std::uint64_t) const {
    return slope_mask(surface, parse_direction(up, "slope.up"));
  }
};

struct FacingMask {
  static constexpr const char *name = "facing", *unit = "1",
                              *summary = "how squarely the place faces a direction: sky, wind, sun";
  std::string towards = "y";
  double sharpness = 1.0;

  template <typename V>
  void parameters(V&& v) {
    v("towards", towards, {}, "direction faced: an axis or three numbers");
    v("sharpness", sharpness, 0.01, 1000.0, "1", "power of the cosine");
  }
  Field<float> make(const Surface& surface, std::uint64_t) const {
    return facing_mask(surface, parse_direction(towards, "facing.towards"), sharpness);
  }
};

struct BentMask {
  double radius = 0.0;

  template <typename V>
  void parameters(V&& v) {
    v("radius", radius, 0.0, 1e9, "unit", "over which bends are seen; 0: a hundredth of the model");
  }
  double used(const Surface& surface) const { return radius > 0.0 ? radius : default_radius(surface); }
};

struct CurvatureMask : BentMask {
  static constexpr const char *name = "curvature", *unit = "1/unit",
                              *summary = "mean curvature, positive where convex";
  Field<float> make(const Surface& s, std::uint64_t) const { return mean_curvature(s, used(s)); }
};

struct ConvexMask : BentMask {
  static constexpr const char *name = "convex", *unit = "1", *summary = "edges and other convex places";
  Field<float> make(const Surface& s, std::uint64_t) const { return convexity(s, used(s)); }
};

struct CavityMask : BentMask {
  static constexpr const char *name = "cavity", *unit = "1", *summary = "grooves and other hollow places";
  Field<float> make(const Surface& s, std::uint64_t) const { return concavity(s, used(s)); }
};

struct LinesMask {
  static constexpr const char *name = "lines", *unit = "unit",
                              *summary = "distance along the surface to painted points and lines";
  std::string lines;
  double most = 0.0;

  template <typename V>
  void parameters(V&& v) {
    v("lines", lines, {}, "\"x y z, x y z; x y z\": points by ',', lines by ';'");
    v("most", most, 0.0, 1e9, "unit", "distance to stop at; 0: nowhere");
  }
  Field<float> make(const Surface& surface, std::uint64_t) const {
    return line_distance(surface, parse_lines(lines, "lines.lines"),
                         most > 0.0 ? most : std::numeric_limits<float>::max());
  }
};

struct ColourMask {
  static constexpr const char *name = "colour", *unit = "1",
                              *summary = "a channel of the model's own colours";
  std::string channel = "luminance";

  template <typename V>
  void parameters(V&& v) {
    v("channel", channel, {"luminance", "red", "green", "blue", "alpha"}, "which one");
  }
  Field<float> make(const Surface& surface, std::uint64_t) const { return colour_mask(surface, channel); }
};

}  // namespace

void add_shape(MaskCatalogue& catalogue) {
  catalogue.add(mask_entry<HeightMask>());
  catalogue.add(mask_entry<SlopeMask>());
  catalogue.add(mask_entry<FacingMask>());
  catalogue.add(mask_entry<CurvatureMask>());
  catalogue.add(mask_entry<ConvexMask>());
  catalogue.add(mask_entry<CavityMask>());
  catalogue.add(mask_entry<LinesMask>());
  catalogue.add(mask_entry<ColourMask>());
}

}  // namespace verdigris
