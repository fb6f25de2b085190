#pragma once
// An experiment as data: one TOML file says mesh, cells, behaviour, seeds and picture; it can be kept,
// shared, replayed.

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "verdigris/base/parameters.hpp"
#include "verdigris/io/animation_plan.hpp"
#include "verdigris/io/corrosion_plan.hpp"
#include "verdigris/io/read_points.hpp"
#include "verdigris/io/weathering_plan.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Where growth starts. One way of giving seeds at a time.
struct SeedPlan {
  std::uint64_t count = 0;              ///< that many at random, uniform by area
  std::vector<WeightedPoint> points;    ///< label k starts at the cell nearest to points[k]
  std::vector<std::uint32_t> vertices;  ///< label k starts at this vertex, counted from 0 in file order
  std::vector<double> weights;          ///< speed of label k, for `count` and `vertices`; empty: all 1

  bool empty() const { return count == 0 && points.empty() && vertices.empty(); }
};

/// A scalar field that drives the behaviour: what it drives is its name. One named "barrier" bars growth
/// instead, where it reaches BarrierPlan::threshold. Others are there for formulas and timelines. It comes
/// from one of `source`, `formula`, `image` and `file`.
struct MaskPlan {
  std::string name;
  std::string source;           ///< of MaskCatalogue, or a primitive, looked up in space
  ParameterValues parameters;   ///< of the source
  std::uint64_t seed = 1;       ///< of the source
  double scale = 1.0;           ///< how many windows of a primitive the model's longest side spans
  std::string formula;          ///< see MaskExpression; over the other masks and the sources of MaskCatalogue
  std::filesystem::path image;  ///< grey values by the model's texture coordinates
  std::filesystem::path file;   ///< numbers, one for each vertex or face of the model's file
  std::string on;               ///< "vertices" or "faces"; empty: told by how many numbers there are
  /// Values that become 0 and 1, any other in proportion and no farther; low may be the greater. None: the
  /// range of a primitive; 0 and 1 of files and images; formulas and sources of MaskCatalogue stay as they
  /// are.
  std::optional<double> low, high;
};

/// Where growth must not go.
struct BarrierPlan {
  double angle = 181.0;        ///< degrees; growth does not cross edges whose faces turn by more
  std::filesystem::path mask;  ///< numbers, one for each vertex or face of the file; empty: none
  std::string mask_on;         ///< "vertices" or "faces"; empty: told by how many numbers there are
  double threshold = 0.5;      ///< cells whose mask is at least this are not covered
};

/// A flat, periodic grid in place of a model; see make_flat_torus.
struct TorusPlan {
  std::uint32_t width = 0, height = 0;  ///< cells; 0: there is a model
  std::uint32_t patch = 64;             ///< length of its triangles, cells
};

/// What to draw.
struct PicturePlan {
  bool draw = true;
  std::string view = "iso";
  std::string up = "y";
  int width = 1280, height = 960;
  bool outline = true;
};

/// Everything a run depends on. Read, run and written again it gives the same result to the bit.
struct Scene {
  std::filesystem::path file;  ///< that it was read from, for messages; empty: from options
  std::filesystem::path mesh;
  TorusPlan torus;        ///< instead of a mesh
  std::string mesh_hash;  ///< expected mesh_hash(); empty: any
  bool mend = false;
  double cells = 1e6;      ///< target count of cells, when cell_size is 0
  double cell_size = 0.0;  ///< model units
  LinkKind links = LinkKind::unfolded;
  std::string behaviour = "voronoi";
  ParameterValues parameters;
  SeedPlan seeds;
  std::vector<MaskPlan> masks;
  BarrierPlan barrier;
  CorrosionPlan corrosion;
  std::uint64_t seed = 1;
  std::uint64_t steps = 0;  ///< 0: until nothing can change
  PicturePlan picture;
  WeatheringPlan weathering;  ///< or none
  AnimationPlan animation;
};

/// Reads a scene; paths in it are relative to the file. Throws InputError with file and line for TOML that
/// does not parse, tables or keys that do not exist, values of the wrong type or out of range, and seeds
/// given in two ways.
Scene read_scene(const std::filesystem::path& file);

/// A scene with every value spelled out, so that read_scene gives back the same from `file`. Paths are
/// relative to its directory where they can be.
std::string scene_text(const std::filesystem::path& file, const Scene& scene);
/// Writes scene_text into `file`.
void write_scene(const std::filesystem::path& file, const Scene& scene);

/// "unfolded" or "projected"; InputError otherwise.
LinkKind link_kind_named(const std::string& name);
const char* name_of(LinkKind kind);

/// InputError, naming `where`, unless `name` is "vertices", "faces" or empty.
void check_mask_on(const std::string& name, const std::string& where);

}  // namespace verdigris
