#include "om_chunks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "binary_numbers.hpp"

namespace verdigris::io {

namespace {

constexpr char remedy_cut[] = "the file may have been cut off or damaged: write it again, or export as PLY";
constexpr std::uint8_t version_2_0 = 2 << 5, version_2_2 = (2 << 5) + 2;  // three bits major, five minor

enum Entity : unsigned { vertex = 0, mesh = 1, face = 2, edge = 4, halfedge = 6, sentinel = 7 };
enum Type : unsigned {
  position = 0,
  normal = 1,
  texcoord = 2,
  status = 3,
  color = 4,
  custom = 6,
  topology = 7
};

/// The 16 bits before a chunk (OMFormat.hh of OpenMesh 9).
struct ChunkHeader {
  explicit ChunkHeader(std::uint16_t b)
      : bits(b),
        named(b >> 1 & 1),
        entity(b >> 2 & 7),
        type(b >> 5 & 15),
        is_float(b >> 10 & 1),
        dimension((b >> 11 & 7) + 1u),
        width(1u << (b >> 14 & 3)) {}

  std::uint16_t bits;
  bool named;
  unsigned entity, type;
  bool is_float;
  unsigned dimension;  ///< numbers in a vector
  unsigned width;      ///< bytes of a whole number; a quarter of the bytes of a fraction
};

class OmWalk {
 public:
  explicit OmWalk(Faults& faults) : faults_(faults), bytes_(faults.text()) {}

  OmChunks walk() {
    read_header();
    for (;;) {
      const std::size_t start = at_;
      if (at_ == bytes_.size()) break;  // versions before 2.1 have no sentinel
      const ChunkHeader chunk(load<std::uint16_t>(take(2).data(), false));
      if (chunk.entity == sentinel) break;
      read_chunk(chunk, start);
    }
    faults_.check();
    if (out_.positions.empty()) faults_.stop(at_, "the file has no vertex positions", remedy_cut);
    const bool complete = has_faces_ && (version_ < version_2_0 || (has_halfedges_ && has_vertices_));
    if (!complete) faults_.stop(at_, "the file has no faces, or not all of their topology", remedy_cut);
    out_.clean += std::string("\x1C\0", 2);  // the sentinel
    return std::move(out_);
  }

 private:
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size() - at_)
      faults_.stop(at_, "the file ends inside a chunk, or its counts are too large for it", remedy_cut);
    const std::string_view part = bytes_.substr(at_, size);
    at_ += size;
    return part;
  }

  void read_header() {
    const std::string_view header = take(16);
    kind_ = header[2];
    version_ = static_cast<std::uint8_t>(header[3]);
    if (!header.starts_with("OM") || (kind_ != 'T' && kind_ != 'Q' && kind_ != 'P'))
      faults_.stop(0, "the file does not begin with OM and T, Q or P",
                   "check that this is a mesh written by OpenMesh");
    if (version_ > version_2_2)
      faults_.stop(3, fmt::format("version {}.{} of OM is newer than 2.2", version_ >> 5, version_ & 31),
                   "export the model as PLY or OBJ");
    out_.vertices = load<std::uint32_t>(header.data() + 4, false);
    out_.faces = load<std::uint32_t>(header.data() + 8, false);
    out_.edges = load<std::uint32_t>(header.data() + 12, false);
    // A vertex takes at least 12 bytes and a face 1: what claims more than the file has ends here, before
    // anything is made.
    if (12ull * out_.vertices + out_.faces + (version_ < version_2_0 ? 0ull : 6ull * out_.edges) >
        bytes_.size())
      faults_.stop(
          4,
          fmt::format("the file is too short for the {} vertices, {} faces and {} edges it announces",
                      out_.vertices, out_.faces, out_.edges),
          remedy_cut);
    out_.clean = header;
  }

  void read_chunk(const ChunkHeader& chunk, std::size_t start) {
    if (chunk.named) {
      take(static_cast<unsigned char>(take(1)[0]));                               // its name
      if (version_ >= version_2_2) take(static_cast<unsigned char>(take(1)[0]));  // its type
    }
    if (chunk.type == custom) {
      take(load<std::uint32_t>(take(4).data(), false));
      return;
    }
    if (chunk.entity == mesh || chunk.named) refuse(start);
    const bool wants_topology = chunk.type == topology;
    if (wants_topology && out_.positions.empty()) refuse(start);
    if (wants_topology && chunk.width > 4) refuse(start);
    switch (chunk.type) {
      case position:
        read_positions(chunk, start);
        break;
      case normal:
        take_vectors(chunk, chunk.is_float && chunk.dimension == 3, 4 * chunk.width, start);
        break;
      case texcoord: {
        const std::string_view data = take_vectors(chunk, chunk.is_float, 4 * chunk.width, start);
        if (chunk.entity == vertex && chunk.dimension == 2 && chunk.width == 1) out_.uvs = data;
        break;
      }
      case status:
        take(std::uint64_t{4} * count(chunk, start));
        break;
      case color: {
        const std::string_view data = take_vectors(chunk, !chunk.is_float, chunk.width, start);
        if (chunk.entity == vertex && chunk.dimension == 3 && chunk.width == 1) out_.colors = data;
        break;
      }
      case topology:
        read_topology(chunk, start);
        break;
      default:
        refuse(start);
    }
    if (chunk.type == position || chunk.type == topology) out_.clean += bytes_.substr(start, at_ - start);
  }

  [[noreturn]] void refuse(std::size_t start) {
    faults_.stop(start, "a chunk of a kind that OpenMesh does not write, or in the wrong order", remedy_cut);
  }

  std::uint64_t count(const ChunkHeader& chunk, std::size_t start) {
    switch (chunk.entity) {
      case vertex:
        return out_.vertices;
      case face:
        return out_.faces;
      case edge:
        return out_.edges;
      case halfedge:
        return std::uint64_t{2} * out_.edges;
      default:
        refuse(start);
    }
  }

  std::string_view take_vectors(const ChunkHeader& chunk, bool good, std::uint64_t bytes, std::size_t start) {
    if (!good) refuse(start);
    return take(count(chunk, start) * chunk.dimension * bytes);
  }

  void read_positions(const ChunkHeader& chunk, std::size_t start) {
    const bool good = chunk.entity == vertex && chunk.is_float && chunk.dimension == 3 && chunk.width <= 2;
    if (!good || !out_.positions.empty()) refuse(start);
    out_.positions = take_vectors(chunk, true, 4 * chunk.width, start);
    out_.doubles = chunk.width == 2;
  }

  /// The next whole number of `width` bytes.
  std::int64_t take_number(unsigned width, bool is_signed) {
    const char* from = take(width).data();
    switch (width) {
      case 1:
        return is_signed ? std::int64_t{load<std::int8_t>(from, false)} : load<std::uint8_t>(from, false);
      case 2:
        return is_signed ? std::int64_t{load<std::int16_t>(from, false)} : load<std::uint16_t>(from, false);
      default:
        return is_signed ? std::int64_t{load<std::int32_t>(from, false)} : load<std::uint32_t>(from, false);
    }
  }

  void check_range(std::int64_t value, std::int64_t from, std::int64_t end, const char* what) {
    if (value >= from && value < end) return;
    if (!faults_.known(remedy_cut))
      faults_.add(at_, fmt::format("{} {} is not there (there are {})", what, value, end), remedy_cut);
  }

  void read_topology(const ChunkHeader& chunk, std::size_t start) {
    const std::int64_t half_edges = 2 * std::int64_t{out_.edges};
    if (version_ < version_2_0) {
      if (chunk.entity != face || has_faces_) refuse(start);
      has_faces_ = true;
      read_face_lists(chunk.width);
    } else if (chunk.entity == halfedge && !has_halfedges_) {
      has_halfedges_ = true;
      for (std::uint32_t e = 0; e < out_.edges; ++e) {
        std::array<std::int64_t, 2> to{};
        for (std::int64_t& end : to) {
          check_range(take_number(chunk.width, true), 0, half_edges, "half-edge");
          check_range(end = take_number(chunk.width, true), 0, out_.vertices, "vertex");
          check_range(take_number(chunk.width, true), -1, out_.faces, "face");
        }
        if (to[0] == to[1] && !faults_.known(remedy_cut))
          faults_.add(at_, fmt::format("edge {} has one vertex at both ends", e), remedy_cut);
      }
    } else if ((chunk.entity == vertex && !has_vertices_) || (chunk.entity == face && !has_faces_)) {
      if (!has_halfedges_) refuse(start);  // what follows would point to nothing
      const bool of_face = chunk.entity == face;
      (of_face ? has_faces_ : has_vertices_) = true;
      for (std::uint64_t i = count(chunk, start); i > 0; --i)
        check_range(take_number(chunk.width, true), of_face ? 0 : -1, half_edges, "half-edge");
    } else {
      refuse(start);
    }
  }

  /// Before version 2.0 faces are lists of vertices.
  void read_face_lists(unsigned width) {
    std::vector<std::int64_t> corners;
    for (std::uint32_t f = 0; f < out_.faces; ++f) {
      const std::int64_t n = kind_ == 'T' ? 3 : kind_ == 'Q' ? 4 : take_number(2, false);
      corners.clear();
      for (std::int64_t k = 0; k < n; ++k) {
        corners.push_back(take_number(width, false));
        check_range(corners.back(), 0, out_.vertices, "vertex");
      }
      std::sort(corners.begin(), corners.end());
      const bool repeats = std::adjacent_find(corners.begin(), corners.end()) != corners.end();
      if ((n < 3 || repeats) && !faults_.known(remedy_cut))
        faults_.add(at_, fmt::format("face {} has fewer than three different corners, or repeats one", f),
                    remedy_cut);
    }
  }

  Faults& faults_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  OmChunks out_;
  char kind_ = 0;
  std::uint8_t version_ = 0;
  bool has_halfedges_ = false, has_vertices_ = false, has_faces_ = false;
};

}  // namespace

OmChunks check_om_chunks(Faults& faults) {
  return OmWalk(faults).walk();
}

}  // namespace verdigris::io
