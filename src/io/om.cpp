// OM, the binary format of OpenMesh, through OpenMesh's reader.

#include <fmt/format.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cmath>
#include <mutex>
#include <sstream>

#include "binary_numbers.hpp"
#include "formats.hpp"
#include "om_chunks.hpp"
#include "polygon_soup.hpp"
#include "text_numbers.hpp"

namespace verdigris::io {

namespace {

using HalfEdges = OpenMesh::PolyMesh_ArrayKernelT<>;

constexpr char remedy_topology[] = "the file may be damaged: write it again, or export as PLY";

/// Sends what OpenMesh has to say to a string instead of the terminal while it lives. The stream's buffer is
/// changed, since OpenMesh's own connect() and disconnect() leak and would forget what the caller has
/// connected.
class QuietOpenMesh {
 public:
  QuietOpenMesh() : log_(swap(omlog(), said_.rdbuf())), error_(swap(omerr(), said_.rdbuf())) {}
  ~QuietOpenMesh() {
    swap(omlog(), log_);
    swap(omerr(), error_);
  }
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;

  std::string said() const { return said_.str(); }

 private:
  static std::streambuf* swap(std::ostream& stream, std::streambuf* buffer) { return stream.rdbuf(buffer); }

  std::ostringstream said_;
  std::streambuf *log_, *error_;
};

HalfEdges read_half_edges(const OmChunks& chunks, Faults& faults) {
  // OpenMesh's reader and its log are one object each for the whole process.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const QuietOpenMesh quiet;
  std::istringstream stream(chunks.clean);
  HalfEdges half_edges;
  OpenMesh::IO::Options options;
  if (!OpenMesh::IO::read_mesh(half_edges, stream, ".om", options))
    faults.stop(0, fmt::format("OpenMesh cannot read it ({})", in_quotes(quiet.said())), remedy_topology);
  // Faces that would not be manifold get copies of their vertices: welding joins these again.
  if (half_edges.n_faces() != chunks.faces || half_edges.n_vertices() < chunks.vertices)
    faults.stop(0, fmt::format("OpenMesh made {} faces of {}", half_edges.n_faces(), chunks.faces),
                remedy_topology);
  return half_edges;
}

/// Positions from the file itself, so that doubles stay doubles; those that OpenMesh copied follow.
void take_vertices(const OmChunks& chunks, const HalfEdges& half_edges, Faults& faults, PolygonSoup& soup) {
  const std::size_t width = chunks.doubles ? 8 : 4;
  for (std::size_t v = 0; v < half_edges.n_vertices(); ++v) {
    glm::dvec3 p;
    for (int c = 0; c < 3; ++c) {
      if (v < chunks.vertices) {
        const char* from = chunks.positions.data() + (3 * v + static_cast<std::size_t>(c)) * width;
        p[c] = chunks.doubles ? load<double>(from, false) : load<float>(from, false);
      } else {
        p[c] = half_edges.point(OpenMesh::VertexHandle(static_cast<int>(v)))[static_cast<std::size_t>(c)];
      }
      const bool good = std::isfinite(p[c]) && std::abs(p[c]) <= largest_number;
      const char* remedy = std::isfinite(p[c]) ? remedy_too_large : remedy_not_finite;
      if (!good && !faults.known(remedy))
        faults.add(static_cast<std::size_t>(chunks.positions.data() - faults.text().data()) + 3 * v * width,
                   fmt::format("vertex {} has a coordinate that is not finite, or too large", v), remedy);
    }
    soup.positions.push_back(p);
    const bool from_file = v < chunks.vertices;
    if (!chunks.uvs.empty()) {
      const char* from = chunks.uvs.data() + 8 * v;
      glm::vec2 uv(0.0F);
      if (from_file) uv = glm::vec2(load<float>(from, false), load<float>(from + 4, false));
      if (!std::isfinite(uv.x + uv.y) && !faults.known(remedy_not_finite))
        faults.add(static_cast<std::size_t>(from - faults.text().data()),
                   fmt::format("a texture coordinate of vertex {} is not finite", v), remedy_not_finite);
      soup.vertex_uv.push_back(uv);
    }
    if (!chunks.colors.empty()) {
      const auto* rgb = reinterpret_cast<const unsigned char*>(chunks.colors.data() + 3 * v);
      soup.vertex_color.push_back(from_file ? glm::vec4(rgb[0], rgb[1], rgb[2], 255.0F) / 255.0F
                                            : glm::vec4(1.0F));
    }
  }
}

/// Walks round each face. No half-edge may come twice, or a damaged file could lead round for ever.
void take_faces(const HalfEdges& half_edges, Faults& faults, PolygonSoup& soup) {
  std::vector<bool> seen(half_edges.n_halfedges(), false);
  for (const auto face : half_edges.all_faces()) {
    const OpenMesh::HalfedgeHandle first = half_edges.halfedge_handle(face);
    OpenMesh::HalfedgeHandle h = first;
    const std::size_t begin = soup.corner_vertex.size();
    do {
      const auto place = static_cast<std::size_t>(h.idx());
      if (!h.is_valid() || place >= seen.size() || seen[place] || half_edges.face_handle(h) != face)
        faults.stop(0, fmt::format("the half-edges of face {} do not go round it", face.idx()),
                    remedy_topology);
      seen[place] = true;
      soup.corner_vertex.push_back(static_cast<std::uint32_t>(half_edges.to_vertex_handle(h).idx()));
      h = half_edges.next_halfedge_handle(h);
    } while (h != first);
    if (soup.corner_vertex.size() - begin < 3)
      faults.stop(0, fmt::format("face {} has fewer than three corners", face.idx()), remedy_topology);
    soup.face_end.push_back(static_cast<std::uint32_t>(soup.corner_vertex.size()));
  }
}

}  // namespace

Mesh read_om(FileBytes bytes, const std::filesystem::path& file, ReadReport& report) {
  report.format = "OM";
  Faults faults(file, bytes.view(), false);
  const OmChunks chunks = check_om_chunks(faults);
  const HalfEdges half_edges = read_half_edges(chunks, faults);
  PolygonSoup soup;
  take_vertices(chunks, half_edges, faults, soup);
  take_faces(half_edges, faults, soup);
  faults.check();
  return to_mesh(std::move(soup), file, report);
}

}  // namespace verdigris::io
