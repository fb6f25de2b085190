// PLY, text and binary (G. Turk, "The PLY Polygon File Format", 1994), with the texture coordinates and
// colours that Blender (s, t), MeshLab (texcoord lists) and scanners write.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "binary_numbers.hpp"
#include "formats.hpp"
#include "ply_header.hpp"
#include "polygon_soup.hpp"
#include "text_cursor.hpp"
#include "text_numbers.hpp"

namespace verdigris::io {

namespace {

constexpr char remedy_rows[] = "the file may have been cut off or edited: export or download it again";

/// Rows of a text file: one line each.
class TextRows {
 public:
  TextRows(std::size_t begin, Faults& faults)
      : cursor_(faults.text().substr(begin)), begin_(begin), faults_(faults) {}

  void begin_row() { word_ = cursor_.word_on_any_line(); }
  void end_row() {
    if (!word_.empty())
      faults_.stop(offset(), "the row has more values than the header announces", remedy_rows);
  }
  std::size_t offset() const { return begin_ + cursor_.word_offset(); }
  std::size_t left() const {
    return (faults_.text().size() - offset() + 1) / 2;
  }  // least bytes of a value: "0 "

  double number(PlyType) {
    if (word_.empty()) faults_.stop(offset(), "the row or the file ends too early", remedy_rows);
    const double value = number_at(word_, offset(), faults_, "value");
    word_ = cursor_.word();
    return value;
  }
  void skip(PlyType) {
    if (word_.empty()) faults_.stop(offset(), "the row or the file ends too early", remedy_rows);
    word_ = cursor_.word();
  }
  bool more() { return !cursor_.word_on_any_line().empty(); }

 private:
  TextCursor cursor_;
  std::size_t begin_;
  Faults& faults_;
  std::string_view word_;
};

/// Rows of a binary file, without gaps.
class BinaryRows {
 public:
  BinaryRows(std::size_t begin, bool big_endian, Faults& faults)
      : at_(begin), big_endian_(big_endian), faults_(faults) {}

  void begin_row() {}
  void end_row() {}
  std::size_t offset() const { return at_; }
  std::size_t left() const { return faults_.text().size() - at_; }

  double number(PlyType type) {
    const char* from = faults_.text().data() + at_;
    skip(type);
    switch (type) {
      case PlyType::int8:
        return load<std::int8_t>(from, big_endian_);
      case PlyType::uint8:
        return load<std::uint8_t>(from, big_endian_);
      case PlyType::int16:
        return load<std::int16_t>(from, big_endian_);
      case PlyType::uint16:
        return load<std::uint16_t>(from, big_endian_);
      case PlyType::int32:
        return load<std::int32_t>(from, big_endian_);
      case PlyType::uint32:
        return load<std::uint32_t>(from, big_endian_);
      case PlyType::float32:
        return checked(load<float>(from, big_endian_));
      default:
        return checked(load<double>(from, big_endian_));
    }
  }
  void skip(PlyType type) {
    const std::size_t size = size_of(type);
    if (size > left()) faults_.stop(at_, "the file ends inside a row", remedy_rows);
    at_ += size;
  }
  /// Padding with zeros or a last line end is nothing; other bytes are rows that the header does not know of.
  bool more() const {
    return faults_.text().find_first_not_of(std::string_view("\0\r\n ", 4), at_) != std::string_view::npos;
  }

 private:
  double checked(double value) {
    if (std::isfinite(value) && std::abs(value) <= largest_number) return value;
    const char* remedy = std::isfinite(value) ? remedy_too_large : remedy_not_finite;
    if (!faults_.known(remedy)) faults_.add(at_, "a value is not finite, or too large", remedy);
    return 0.0;
  }

  std::size_t at_;
  bool big_endian_;
  Faults& faults_;
};

/// What a property means to us.
enum class Role : std::uint8_t { none, x, y, z, u, v, red, green, blue, alpha, corners, corner_uv };
constexpr std::size_t roles = 12;

Role role_of(const PlyProperty& p) {
  struct Named {
    std::string_view name;
    Role role;
    bool list;
  };
  static constexpr std::array names{
      Named{"x", Role::x, false},
      Named{"y", Role::y, false},
      Named{"z", Role::z, false},
      Named{"s", Role::u, false},
      Named{"t", Role::v, false},
      Named{"u", Role::u, false},
      Named{"v", Role::v, false},
      Named{"texture_u", Role::u, false},
      Named{"texture_v", Role::v, false},
      Named{"red", Role::red, false},
      Named{"green", Role::green, false},
      Named{"blue", Role::blue, false},
      Named{"alpha", Role::alpha, false},
      Named{"diffuse_red", Role::red, false},
      Named{"diffuse_green", Role::green, false},
      Named{"diffuse_blue", Role::blue, false},
      Named{"vertex_indices", Role::corners, true},
      Named{"vertex_index", Role::corners, true},
      Named{"texcoord", Role::corner_uv, true},
  };
  for (const Named& n : names)
    if (n.name == p.name && n.list == p.list) return n.role;
  return Role::none;
}

/// 1 for what is in 0..1 already.
double color_scale(PlyType type) {
  if (type >= PlyType::float32) return 1.0;
  return type == PlyType::uint16 ? 1.0 / 65535.0 : 1.0 / 255.0;
}

template <class Rows>
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, Rows rows, Faults& faults) : rows_(rows), faults_(faults) {
    for (const PlyElement& e : header.elements) {
      if (e.name == "vertex") vertices_ += e.rows;
      if (e.name == "tristrips") strips_ = e.rows > 0;
    }
  }

  PolygonSoup read(const PlyHeader& header) {
    for (const PlyElement& element : header.elements) read_element(element);
    if (rows_.more()) faults_.stop(rows_.offset(), "there is more after the last row", remedy_rows);
    faults_.check();
    if (soup_.face_end.empty() && strips_)
      faults_.stop(0, "triangle strips ('tristrips') are not read", "export the model with plain faces");
    return std::move(soup_);
  }

 private:
  struct Column {
    PlyProperty property;
    Role role;
  };

  void read_element(const PlyElement& element) {
    const bool vertex = element.name == "vertex", face = element.name == "face";
    bool& seen = vertex ? seen_vertex_ : seen_face_;
    if ((vertex || face) && std::exchange(seen, true))
      faults_.stop(element.offset, fmt::format("there is a second element {}", in_quotes(element.name)),
                   remedy_rows);
    std::vector<Column> columns;
    std::array<bool, roles> has{};
    for (const PlyProperty& p : element.properties) {
      const Role role = vertex || face ? role_of(p) : Role::none;
      columns.push_back({p, role});
      has[static_cast<std::size_t>(role)] = true;
    }
    auto with = [&has](Role role) { return has[static_cast<std::size_t>(role)]; };
    static constexpr char remedy[] =
        "export the model again as a polygon mesh: x, y, z and vertex_indices are needed";
    if (vertex && !(with(Role::x) && with(Role::y) && with(Role::z)))
      faults_.stop(element.offset, "the vertices have no x, y, z", remedy);
    if (face && !with(Role::corners))
      faults_.stop(element.offset, "the faces have no list vertex_indices", remedy);
    const bool uv = with(Role::u) && with(Role::v);
    const bool color = with(Role::red) && with(Role::green) && with(Role::blue);
    if (vertex) soup_.positions.reserve(element.rows);
    if (face) {
      soup_.face_end.reserve(element.rows);
      soup_.corner_vertex.reserve(3 * element.rows);
    }

    for (std::size_t row = 0; row < element.rows; ++row) {
      rows_.begin_row();
      const std::size_t offset = rows_.offset();
      std::array<double, roles> value{};
      value[static_cast<std::size_t>(Role::alpha)] = 1.0;
      corners_.clear();
      corner_uv_.clear();
      for (const auto& [property, role] : columns) {
        if (property.list)
          read_list(property, role);
        else if (role == Role::none)
          rows_.skip(property.type);
        else
          value[static_cast<std::size_t>(role)] =
              rows_.number(property.type) * (role >= Role::red ? color_scale(property.type) : 1.0);
      }
      rows_.end_row();
      auto at = [&value](Role role) { return value[static_cast<std::size_t>(role)]; };
      const glm::vec4 rgba(at(Role::red), at(Role::green), at(Role::blue), at(Role::alpha));
      if (vertex) {
        soup_.positions.push_back({at(Role::x), at(Role::y), at(Role::z)});
        if (uv) soup_.vertex_uv.push_back({at(Role::u), at(Role::v)});
        if (color) soup_.vertex_color.push_back(rgba);
      } else if (face) {
        add_face(offset, row);
        if (with(Role::corner_uv)) add_corner_uv();
        if (color) soup_.face_color.push_back(rgba);
      }
    }
  }

  void read_list(const PlyProperty& property, Role role) {
    const std::size_t offset = rows_.offset();
    const double length = rows_.number(property.count_type);
    if (length < 0.0 || length != std::floor(length) || length > static_cast<double>(rows_.left()))
      faults_.stop(offset, fmt::format("a list of {} values does not fit in the file", length), remedy_rows);
    std::vector<double>* to =
        role == Role::corners ? &corners_ : (role == Role::corner_uv ? &corner_uv_ : nullptr);
    for (auto i = static_cast<std::size_t>(length); i > 0; --i) {
      if (to)
        to->push_back(rows_.number(property.type));
      else
        rows_.skip(property.type);
    }
  }

  void add_face(std::size_t offset, std::size_t row) {
    if (corners_.size() < 3) {
      if (!faults_.known(remedy_corners))
        faults_.add(offset, fmt::format("face {} has {} corners", row, corners_.size()), remedy_corners);
    }
    for (const double corner : corners_) {
      const bool good =
          corner >= 0.0 && corner < static_cast<double>(vertices_) && corner == std::floor(corner);
      if (!good && !faults_.known(remedy_index))
        faults_.add(offset,
                    fmt::format("face {} has the corner {}, which is not one of the {} vertices", row, corner,
                                vertices_),
                    remedy_index);
      soup_.corner_vertex.push_back(good ? static_cast<std::uint32_t>(corner) : 0);
    }
    soup_.face_end.push_back(static_cast<std::uint32_t>(soup_.corner_vertex.size()));
    if (soup_.corner_vertex.size() >= 0xFFFFFF00u)
      faults_.stop(offset, "more faces than 32-bit numbers can count", remedy_too_many);
  }

  /// MeshLab's list of u and v for every corner; empty for a face without.
  void add_corner_uv() {
    const bool fits = corner_uv_.size() == 2 * corners_.size();
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      soup_.corner_uv.push_back(fits ? static_cast<std::uint32_t>(soup_.uv.size()) : PolygonSoup::none);
      if (fits) soup_.uv.push_back({corner_uv_[2 * k], corner_uv_[2 * k + 1]});
    }
  }

  Rows rows_;
  Faults& faults_;
  PolygonSoup soup_;
  std::size_t vertices_ = 0;
  bool strips_ = false, seen_vertex_ = false, seen_face_ = false;
  std::vector<double> corners_, corner_uv_;  // of the row being read
};

}  // namespace

Mesh read_ply(FileBytes bytes, const std::filesystem::path& file, ReadReport& report) {
  blank_byte_order_mark(bytes);
  Faults header_faults(file, bytes.view(), true);
  const PlyHeader header = read_ply_header(header_faults);
  PolygonSoup soup;
  if (header.format == PlyFormat::text) {
    report.format = "PLY (text)";
    prepare_text(bytes, file);
    soup = PlyBody<TextRows>(header, TextRows(header.size, header_faults), header_faults).read(header);
  } else {
    const bool big_endian = header.format == PlyFormat::big_endian;
    report.format = big_endian ? "PLY (binary big-endian)" : "PLY (binary little-endian)";
    Faults faults(file, bytes.view(), false);
    soup = PlyBody<BinaryRows>(header, BinaryRows(header.size, big_endian, faults), faults).read(header);
  }
  return to_mesh(std::move(soup), file, report);
}

}  // namespace verdigris::io
