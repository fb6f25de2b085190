// Object File Format as Geomview 1.9's manual has it (OOGL, "OFF Files"): OFF with the prefixes ST, C and N,
// face colours.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "formats.hpp"
#include "polygon_soup.hpp"
#include "text_cursor.hpp"
#include "text_numbers.hpp"

namespace verdigris::io {

namespace {

constexpr char remedy_header[] =
    "begin the file with OFF (or COFF, NOFF, STOFF and combinations), then the three counts";
constexpr char remedy_counts[] =
    "make the counts in the second line match the lines that follow, or download the file again";

/// 0..1 of a colour that is written as whole numbers 0..255 or as fractions 0..1.
glm::vec4 color_of(std::array<std::string_view, 4> words, std::size_t count,
                   const std::array<double, 4>& value) {
  bool fractions = false;
  for (std::size_t i = 0; i < count; ++i)
    fractions = fractions || words[i].find_first_of(".eE") != std::string_view::npos;
  const double scale = fractions ? 1.0 : 1.0 / 255.0;
  return glm::vec4(value[0] * scale, value[1] * scale, value[2] * scale, count == 4 ? value[3] * scale : 1.0);
}

class OffReader {
 public:
  OffReader(std::string_view text, const std::filesystem::path& file)
      : cursor_(text), faults_(file, text, true) {}

  PolygonSoup read() {
    read_header();
    read_counts();
    for (std::size_t v = 0; v < vertices_; ++v) read_vertex();
    for (std::size_t f = 0; f < faces_; ++f) read_face();
    if (!cursor_.at_end()) {
      cursor_.next_line();
      if (const std::string_view word = cursor_.word_on_any_line(); !word.empty())
        faults_.add(cursor_.word_offset(), "there is more after the last face", remedy_counts);
    }
    faults_.check();
    if (!any_face_color_) soup_.face_color.clear();
    return std::move(soup_);
  }

 private:
  void read_header() {
    std::string_view word = cursor_.word_on_any_line();
    const std::size_t offset = cursor_.word_offset();
    if (word.starts_with("ST")) {
      with_uv_ = true;
      word.remove_prefix(2);
    }
    if (word.starts_with("C")) {
      with_color_ = true;
      word.remove_prefix(1);
    }
    if (word.starts_with("N")) {
      with_normal_ = true;
      word.remove_prefix(1);
    }
    if (word.starts_with("4OFF") || word.starts_with("4nOFF") || word.starts_with("nOFF"))
      faults_.stop(offset, "this OFF file is not three-dimensional",
                   "export the model as plain, three-dimensional OFF");
    if (!word.starts_with("OFF")) faults_.stop(offset, "the file does not begin with OFF", remedy_header);
    word.remove_prefix(3);
    // The counts may follow on the same line, and in a well-known collection (ModelNet) even without a space.
    first_count_ = word.empty() ? cursor_.word_on_any_line() : word;
    if (first_count_ == "BINARY")
      faults_.stop(offset, "binary OFF is not read", "export the model as OFF text, or as PLY");
  }

  void read_counts() {
    const std::size_t offset = cursor_.word_offset();
    const auto vertices = parse_integer(first_count_), faces = parse_integer(cursor_.word_on_any_line());
    if (!vertices || !faces || *vertices < 0 || *faces < 0)
      faults_.stop(offset, "the counts of vertices and faces are missing or malformed", remedy_header);
    cursor_.word();  // the count of edges: nobody relies on it
    // A vertex takes at least "0 0 0\n", a face "3 0 1 2\n" (the last line end may be missing).
    const std::size_t left = faults_.text().size() - cursor_.offset() + 1;
    const auto claimed_vertices = static_cast<std::uint64_t>(*vertices),
               claimed_faces = static_cast<std::uint64_t>(*faces);
    if (claimed_vertices > left / 6 || claimed_faces > left / 4 ||
        6 * claimed_vertices + 4 * claimed_faces > left)
      faults_.stop(offset,
                   fmt::format("the file is too short for the {} vertices and {} faces it announces",
                               *vertices, *faces),
                   remedy_counts);
    vertices_ = claimed_vertices;
    faces_ = claimed_faces;
    soup_.positions.reserve(vertices_);
    soup_.face_end.reserve(faces_);
    soup_.corner_vertex.reserve(3 * faces_);
    if (with_color_) soup_.vertex_color.reserve(vertices_);
    if (with_uv_) soup_.vertex_uv.reserve(vertices_);
  }

  /// The first word of the next line that has any.
  std::string_view next_row(const char* what, std::size_t number, std::size_t of) {
    cursor_.next_line();
    const std::string_view word = cursor_.word_on_any_line();
    if (word.empty())
      faults_.stop(cursor_.offset(), fmt::format("the file ends before {} {} of {}", what, number + 1, of),
                   remedy_counts);
    return word;
  }

  void read_vertex() {
    const std::string_view word = next_row("vertex", soup_.positions.size(), vertices_);
    glm::dvec3 p;
    p.x = number_at(word, cursor_.word_offset(), faults_, "coordinate");
    p.y = next_number(cursor_, faults_, "coordinate");
    p.z = next_number(cursor_, faults_, "coordinate");
    soup_.positions.push_back(p);
    // Normals come before colours (Geomview); they are checked and dropped.
    if (with_normal_)
      for (int i = 0; i < 3; ++i) next_number(cursor_, faults_, "normal");
    std::array<std::string_view, 7> words;
    std::array<std::size_t, 7> at{};
    std::size_t count = 0;
    for (std::string_view w = cursor_.word(); !w.empty(); w = cursor_.word()) {
      if (count < words.size()) {
        words[count] = w;
        at[count] = cursor_.word_offset();
      }
      ++count;
    }
    const std::size_t uv = with_uv_ ? 2 : 0;
    const bool fits = with_color_ ? count == uv + 3 || count == uv + 4 : count == uv;
    if (!fits) {
      static constexpr char remedy[] =
          "one vertex a line, with the values that the first word promises (C: colour, N: normal, ST: "
          "texture)";
      if (!faults_.known(remedy))
        faults_.add(cursor_.offset(), "this vertex has too few or too many values", remedy);
      count = uv;
    }
    if (with_color_) {
      const std::size_t parts = count - uv;
      std::array<double, 4> value{};
      for (std::size_t i = 0; i < parts; ++i) value[i] = number_at(words[i], at[i], faults_, "colour");
      soup_.vertex_color.push_back(color_of({words[0], words[1], words[2], words[3]}, parts, value));
    }
    if (with_uv_) {
      const std::size_t from = count - uv;
      const double u = number_at(words[from], at[from], faults_, "texture coordinate");
      soup_.vertex_uv.push_back({u, number_at(words[from + 1], at[from + 1], faults_, "texture coordinate")});
    }
  }

  void read_face() {
    const std::string_view word = next_row("face", soup_.faces(), faces_);
    const std::size_t line = cursor_.word_offset();
    const auto corners = parse_integer(word);
    if (!corners || *corners < 0)
      faults_.stop(line, fmt::format("the number of corners {} is malformed", in_quotes(word)),
                   remedy_counts);
    if (*corners < 3) {
      if (!faults_.known(remedy_corners))
        faults_.add(line, fmt::format("a face of {} corners", *corners), remedy_corners);
    }
    for (std::int64_t k = 0; k < *corners; ++k) {
      const std::string_view corner = cursor_.word();
      if (corner.empty())
        faults_.stop(line, fmt::format("this face announces {} corners and lists {}", *corners, k),
                     remedy_counts);
      const auto vertex = parse_integer(corner);
      if (!vertex || *vertex < 0 || static_cast<std::uint64_t>(*vertex) >= vertices_) {
        if (!faults_.known(remedy_index))
          faults_.add(cursor_.word_offset(),
                      fmt::format("the corner {} is not the number of a vertex (0 to {})", in_quotes(corner),
                                  static_cast<std::int64_t>(vertices_) - 1),
                      remedy_index);
        soup_.corner_vertex.push_back(0);
      } else {
        soup_.corner_vertex.push_back(static_cast<std::uint32_t>(*vertex));
      }
    }
    soup_.face_end.push_back(static_cast<std::uint32_t>(soup_.corner_vertex.size()));
    if (soup_.corner_vertex.size() >= 0xFFFFFF00u)
      faults_.stop(line, "more faces than 32-bit numbers can count", remedy_too_many);
    read_face_color();
  }

  /// r g b, r g b a; one number is an entry of a palette that is not in the file, and is passed over.
  void read_face_color() {
    std::array<std::string_view, 4> words;
    std::array<double, 4> value{};
    std::size_t count = 0;
    for (std::string_view w = cursor_.word(); !w.empty() && count < 4; w = cursor_.word()) {
      value[count] = number_at(w, cursor_.word_offset(), faults_, "colour");
      words[count++] = w;
    }
    if (with_color_) return;  // vertex colours say more
    if (count < 3 && !any_face_color_) return;
    if (!any_face_color_) {
      any_face_color_ = true;
      soup_.face_color.assign(soup_.faces() - 1, glm::vec4(1.0F));
    }
    soup_.face_color.push_back(count < 3 ? glm::vec4(1.0F) : color_of(words, count, value));
  }

  TextCursor cursor_;
  Faults faults_;
  PolygonSoup soup_;
  std::string_view first_count_;
  std::size_t vertices_ = 0, faces_ = 0;
  bool with_uv_ = false, with_color_ = false, with_normal_ = false, any_face_color_ = false;
};

}  // namespace

Mesh read_off(FileBytes bytes, const std::filesystem::path& file, ReadReport& report) {
  report.format = "OFF";
  // Binary OFF has zeros in it and deserves its own message.
  if (bytes.view().substr(0, 64).find("BINARY") == std::string_view::npos) prepare_text(bytes, file);
  return to_mesh(OffReader(bytes.view(), file).read(), file, report);
}

}  // namespace verdigris::io
