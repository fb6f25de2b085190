// Wavefront OBJ: polygons, texture coordinates, and colours on vertex lines. B. Paul's account of the format
// ("Object Files (.obj)", Wavefront Advanced Visualizer manual, appendix B1).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "formats.hpp"
#include "polygon_soup.hpp"
#include "text_cursor.hpp"
#include "text_numbers.hpp"

namespace verdigris::io {

namespace {

/// Joins lines that end in a backslash, in place: every byte keeps its offset. Comments are left alone, since
/// a path at the end of one ("# C:\models\") is no continuation.
void join_continued_lines(char* text, std::size_t size) {
  char* const end = text + size;
  for (char* at = text; (at = static_cast<char*>(std::memchr(at, '\\', static_cast<std::size_t>(end - at))));
       ++at) {
    char* stop = at + 1;
    if (stop < end && *stop == '\r') ++stop;
    if (stop < end && *stop == '\n') ++stop;
    if (stop == at + 1) continue;
    char* line = at;
    while (line > text && line[-1] != '\n' && line[-1] != '\r') --line;
    if (std::find(line, at, '#') != at) continue;
    std::fill(at, stop, ' ');
    stop[-1] = '\v';  // so that line numbers still come out right
  }
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::filesystem::path& file)
      : cursor_(text), faults_(file, text, true) {}

  PolygonSoup read() {
    for (; !cursor_.at_end(); cursor_.next_line()) {
      const std::string_view keyword = cursor_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "vt")
        read_uv();
      else if (keyword == "vn")
        ++normals_;
      else if (keyword == "f" || keyword == "fo")  // "fo" is what the first versions wrote
        read_face();
    }
    check_ranges();
    faults_.check();
    if (!any_color_) soup_.vertex_color.clear();
    if (!any_uv_) {
      soup_.corner_uv.clear();
      soup_.uv.clear();
    }
    return std::move(soup_);
  }

 private:
  void read_vertex() {
    std::array<double, 7> value{};
    std::size_t count = 0;
    const std::size_t line = cursor_.word_offset();
    for (std::string_view word = cursor_.word(); !word.empty(); word = cursor_.word()) {
      if (count == value.size()) {
        ++count;
        break;
      }
      value[count++] = number_at(word, cursor_.word_offset(), faults_, "coordinate");
    }
    if (count < 3) fault_number(faults_, line, {}, NumberState::malformed, "coordinate");
    if (count > value.size() || count == 5) {
      static constexpr char remedy[] = "write x y z, x y z w, x y z r g b or x y z r g b a, and export again";
      if (!faults_.known(remedy))
        faults_.add(line, "this vertex has a number of values that no writer of OBJ uses", remedy);
    }
    soup_.positions.push_back({value[0], value[1], value[2]});
    if (count >= 6 && !any_color_) {
      any_color_ = true;
      soup_.vertex_color.assign(soup_.positions.size() - 1, glm::vec4(1.0F));
    }
    if (any_color_) {
      glm::vec4 color(1.0F);
      if (count >= 6) color = glm::vec4(value[3], value[4], value[5], count == 7 ? value[6] : 1.0);
      soup_.vertex_color.push_back(color);
    }
  }

  void read_uv() {
    const double u = next_number(cursor_, faults_, "texture coordinate");
    const std::string_view second = cursor_.word();  // v may be left out
    const double v =
        second.empty() ? 0.0 : number_at(second, cursor_.word_offset(), faults_, "texture coordinate");
    soup_.uv.push_back({u, v});
  }

  void read_face() {
    const std::size_t line = cursor_.word_offset();
    std::size_t corners = 0;
    for (std::string_view word = cursor_.word(); !word.empty(); word = cursor_.word(), ++corners)
      read_corner(word);
    if (corners < 3) {
      if (!faults_.known(remedy_corners))
        faults_.add(line, fmt::format("a face of {} corner{}", corners, corners == 1 ? "" : "s"),
                    remedy_corners);
    }
    soup_.face_end.push_back(static_cast<std::uint32_t>(soup_.corner_vertex.size()));
    if (soup_.corner_vertex.size() >= 0xFFFFFF00u)
      faults_.stop(line, "more faces than 32-bit numbers can count", remedy_too_many);
  }

  /// One of `v`, `v/vt`, `v//vn`, `v/vt/vn`.
  void read_corner(std::string_view word) {
    const std::size_t offset = cursor_.word_offset();
    std::array<std::uint32_t, 3> index{PolygonSoup::none, PolygonSoup::none, PolygonSoup::none};
    const std::array<std::size_t, 3> so_far{soup_.positions.size(), soup_.uv.size(), normals_};
    const char* at = word.data();
    const char* const end = at + word.size();
    bool good = true;
    for (std::size_t part = 0; part < 3 && good; ++part) {
      if (at != end && *at != '/') {
        std::int64_t value = 0;
        const auto [stop, error] = std::from_chars(at, end, value);
        good = error == std::errc() && value != 0;
        if (value < 0) value += static_cast<std::int64_t>(so_far[part]) + 1;  // -1 is the latest so far
        if (value < 1 || value >= std::int64_t{PolygonSoup::none}) {
          index[part] = PolygonSoup::none - 1;  // out of any range; said with the others
        } else {
          index[part] = static_cast<std::uint32_t>(value - 1);
        }
        at = stop;
      } else if (part == 0) {
        good = false;  // v//vn, and some writers' v/ and v//, leave others out
      }
      if (at == end) break;
      good = good && *at == '/' && part < 2;
      ++at;
    }
    if (!good) {
      static constexpr char remedy[] =
          "write corners as v, v/vt, v//vn or v/vt/vn, counting from 1 or back from -1";
      if (!faults_.known(remedy))
        faults_.add(offset, fmt::format("the face corner {} is malformed", in_quotes(word)), remedy);
      index = {0, PolygonSoup::none, PolygonSoup::none};
    }
    // Positive indices may point forward, so only a bound is kept here; the rare fault is looked for again.
    for (std::size_t part = 0; part < 3; ++part)
      if (index[part] != PolygonSoup::none && (!top_set_[part] || index[part] > top_[part])) {
        top_[part] = index[part];
        top_set_[part] = true;
        top_offset_[part] = offset;
      }
    soup_.corner_vertex.push_back(index[0]);
    soup_.corner_uv.push_back(index[1]);
    any_uv_ = any_uv_ || index[1] != PolygonSoup::none;
  }

  void check_ranges() {
    const std::array<std::size_t, 3> sizes{soup_.positions.size(), soup_.uv.size(), normals_};
    static constexpr std::array names{"vertex", "texture coordinate", "normal"};
    for (std::size_t part = 0; part < 3; ++part) {
      if (!top_set_[part] || top_[part] < sizes[part]) continue;
      std::string problem = fmt::format("this corner points to a {} that is not there (the file has {})",
                                        names[part], sizes[part]);
      if (part < 2) {
        const auto& corners = part == 0 ? soup_.corner_vertex : soup_.corner_uv;
        const auto bad = std::count_if(corners.begin(), corners.end(), [&](std::uint32_t index) {
          return index != PolygonSoup::none && index >= sizes[part];
        });
        problem += fmt::format("; {} such corner{} in all", bad, bad == 1 ? "" : "s");
      }
      faults_.add(top_offset_[part], problem, remedy_index);
    }
  }

  TextCursor cursor_;
  Faults faults_;
  PolygonSoup soup_;
  std::size_t normals_ = 0;
  bool any_uv_ = false, any_color_ = false;
  std::array<std::uint32_t, 3> top_{};  // [v, vt, vn] highest index used
  std::array<bool, 3> top_set_{};
  std::array<std::size_t, 3> top_offset_{};
};

/// Some exporters write colours as 0..255. A file where any is above 1 is taken to mean that.
void scale_colors(std::vector<glm::vec4>& colors) {
  float most = 0.0F;
  for (const glm::vec4& c : colors) most = std::max({most, c.x, c.y, c.z});
  if (most <= 1.0F) return;
  for (glm::vec4& c : colors) c = glm::vec4(c.x / 255.0F, c.y / 255.0F, c.z / 255.0F, std::min(c.w, 1.0F));
}

}  // namespace

Mesh read_obj(FileBytes bytes, const std::filesystem::path& file, ReadReport& report) {
  report.format = "OBJ";
  prepare_text(bytes, file);
  join_continued_lines(bytes.data(), bytes.size());
  PolygonSoup soup = ObjReader(bytes.view(), file).read();
  scale_colors(soup.vertex_color);
  return to_mesh(std::move(soup), file, report);
}

}  // namespace verdigris::io
