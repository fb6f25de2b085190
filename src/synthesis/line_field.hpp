#pragma once
// How near a point is to the lines that a turtle drew.

#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/synthesis/scalar_field.hpp"
#include "verdigris/synthesis/turtle.hpp"

namespace verdigris::synthesis {

/// 1 on the lines, falling to 0 at distance `falloff`. The lines are laid into the unit box, as large as they
/// fit, its middle on theirs; lines in the plane z = 0 are walls along z.
class LineField final : public ScalarField {
 public:
  LineField(std::span<const TurtleLine> lines, double falloff);

  ValueRange range() const override { return {0.0f, 1.0f, true}; }

 private:
  struct Segment {
    glm::dvec3 from, to;
  };
  void compute(const Points& points, double footprint, std::span<float> out) const override;
  double distance(const glm::dvec3& p, double most) const;
  glm::ivec3 bin_of(const glm::dvec3& p) const;
  std::size_t index(const glm::ivec3& bin) const;
  template <typename Visit>
  void bins_of(const Segment& segment, Visit&& visit) const;

  double falloff_;
  bool flat_ = true;
  std::vector<Segment> segments_;
  // The unit box in cubes; the segments that come into each.
  glm::ivec3 bins_{1};
  std::vector<std::uint32_t> begin_, members_;
};

}  // namespace verdigris::synthesis
