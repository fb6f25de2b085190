#pragma once
// Iterated function systems: a few contractions whose images together make up one set, the attractor.
// Sources: Hutchinson 1981, "Fractals and self-similarity"; Barnsley & Demko 1985, "Iterated function systems
// and the global construction of fractals"; Barnsley 1988, "Fractals Everywhere".

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace verdigris {

/// p -> linear p + offset.
struct AffineMap {
  glm::dmat3 linear{1.0};
  glm::dvec3 offset{0.0};
  double weight = 1.0;  ///< how often the chaos game takes it, relative to the others; > 0

  glm::dvec3 operator()(const glm::dvec3& p) const { return linear * p + offset; }
};

/// The greatest factor by which a map stretches any length.
double stretch(const glm::dmat3& linear);

/// Contractions of the plane z = 0 or of space.
struct FunctionSystem {
  int dimension = 2;
  std::vector<AffineMap> maps;
};

/// Reads maps, one a line or between semicolons; `#` begins a comment. In the plane 6 numbers, a b c d e f
/// for (a x + b y + e, c x + d y + f); in space 12, the three rows of 4 (three factors, then the offset). One
/// more number is the weight; without it, maps are taken in proportion to the area or volume of their images.
/// Throws InputError naming `where`, line and column, for maps that are no contractions too.
FunctionSystem parse_function_system(std::string_view text, const std::string& where);

/// sierpinski-triangle, sierpinski-tetrahedron, menger-sponge, barnsley-fern. Throws InputError otherwise.
FunctionSystem named_function_system(std::string_view name);
std::span<const char* const> function_system_names();

/// A ball that holds the attractor.
struct Ball {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};
Ball attractor_ball(const FunctionSystem& system);

/// Points of the attractor by Barnsley's chaos game, as chains of 1024 that each have random numbers of their
/// own: any number of threads gives the same points in the same order.
std::vector<glm::dvec3> chaos_game(const FunctionSystem& system, std::size_t count, std::uint64_t seed);

/// Distances to the attractor, by search through the images of its ball.
class AttractorDistance {
 public:
  /// Distances are those to points of the attractor, and too great by twice `tolerance` at most.
  AttractorDistance(const FunctionSystem& system, double tolerance);

  /// The distance of `p`, or `most` if it is greater. Where maps overlap so much that a search would not end,
  /// the distance of the nearest point found among 40,000 images: too great, if anything.
  double operator()(const glm::dvec3& p, double most) const;
  const Ball& ball() const { return ball_; }

 private:
  std::vector<AffineMap> maps_;
  Ball ball_;
  glm::dvec3 point_;  // of the attractor
  double tolerance_;
};

}  // namespace verdigris
