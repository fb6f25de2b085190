// Stereolithography files, text and binary (3D Systems, "StereoLithography Interface Specification", 1988).

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "binary_numbers.hpp"
#include "formats.hpp"
#include "polygon_soup.hpp"
#include "text_cursor.hpp"
#include "text_numbers.hpp"

namespace verdigris::io {

namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

/// Whether `word` is `keyword`, in capitals or not.
bool is(std::string_view word, std::string_view keyword) {
  if (word.size() != keyword.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if ((word[i] >= 'A' && word[i] <= 'Z' ? word[i] - 'A' + 'a' : word[i]) != keyword[i]) return false;
  return true;
}

std::size_t announced_facets(std::string_view bytes) {
  return load<std::uint32_t>(bytes.data() + 80, false);
}

PolygonSoup read_binary(std::string_view bytes, const std::filesystem::path& file) {
  Faults faults(file, bytes, false);
  const std::size_t facets = announced_facets(bytes);
  PolygonSoup soup;
  soup.positions.reserve(3 * facets);
  for (std::size_t f = 0; f < facets; ++f) {
    const std::size_t at =
        header_bytes + f * facet_bytes + 12;  // the normal follows from the corners, and is often wrong
    for (std::size_t k = 0; k < 3; ++k) {
      glm::dvec3 p;
      for (int c = 0; c < 3; ++c) {
        const std::size_t place = at + 12 * k + 4 * static_cast<std::size_t>(c);
        p[c] = load<float>(bytes.data() + place, false);
        if (!std::isfinite(p[c])) {
          if (!faults.known(remedy_not_finite))
            faults.add(place, fmt::format("facet {} has a coordinate that is not finite", f + 1),
                       remedy_not_finite);
        }
      }
      soup.positions.push_back(p);
    }
  }
  faults.check();
  return soup;
}

constexpr char remedy_text[] =
    "the file may have been cut off or edited: export or download it again, if possible as PLY";

class TextStl {
 public:
  TextStl(std::string_view text, const std::filesystem::path& file)
      : cursor_(text), faults_(file, text, true) {}

  PolygonSoup read() {
    while (!next().empty()) {  // more than one solid is common
      if (!is(word_, "solid")) unexpected("solid");
      cursor_.skip_rest();  // its name
      read_solid();
    }
    faults_.check();
    return std::move(soup_);
  }

 private:
  std::string_view next() { return word_ = cursor_.word_on_any_line(); }

  [[noreturn]] void unexpected(const char* wanted) {
    const std::string found = word_.empty() ? "the file ends" : fmt::format("there is {}", in_quotes(word_));
    faults_.stop(cursor_.word_offset(), fmt::format("{} where '{}' should be", found, wanted), remedy_text);
  }

  void expect(const char* keyword) {
    if (!is(next(), keyword)) unexpected(keyword);
  }

  void read_solid() {
    for (;;) {
      next();
      if (is(word_, "endsolid")) break;
      if (!is(word_, "facet")) unexpected("endsolid");
      expect("normal");
      for (int c = 0; c < 3; ++c) next();  // often nan for facets of no area: the corners say it better
      expect("outer");
      expect("loop");
      for (int k = 0; k < 3; ++k) {
        expect("vertex");
        glm::dvec3 p;
        for (int c = 0; c < 3; ++c) p[c] = next_number(cursor_, faults_, "coordinate");
        soup_.positions.push_back(p);
      }
      expect("endloop");
      expect("endfacet");
    }
    cursor_.skip_rest();
  }

  TextCursor cursor_;
  Faults faults_;
  PolygonSoup soup_;
  std::string_view word_;
};

/// Every three vertices are a face.
void number_corners(PolygonSoup& soup, const std::filesystem::path& file) {
  const std::size_t corners = soup.positions.size();
  if (corners >= 0xFFFFFF00u)
    throw InputError(shown(file), "more facets than 32-bit numbers can count", remedy_too_many);
  soup.corner_vertex.resize(corners);
  soup.face_end.resize(corners / 3);
  for (std::uint32_t c = 0; c < corners; ++c) soup.corner_vertex[c] = c;
  for (std::uint32_t f = 0; f < corners / 3; ++f) soup.face_end[f] = 3 * f + 3;
}

}  // namespace

// The size decides, not the word "solid": many binary files begin with it too.
Mesh read_stl(FileBytes bytes, const std::filesystem::path& file, ReadReport& report) {
  PolygonSoup soup;
  const std::string_view view = bytes.view();
  const bool long_enough = view.size() >= header_bytes;
  if (long_enough && view.size() == header_bytes + facet_bytes * announced_facets(view)) {
    report.format = "STL (binary)";
    soup = read_binary(view, file);
  } else {
    if (std::memchr(view.data(), 0, view.size())) {
      const std::string problem =
          long_enough
              ? fmt::format("binary STL of {} facets takes {} bytes, but the file has {}",
                            announced_facets(view), header_bytes + facet_bytes * announced_facets(view),
                            view.size())
              : fmt::format("{} bytes are too few for binary STL, whose header alone has 84", view.size());
      throw InputError(shown(file), problem,
                       "the file may have been cut off or padded: export or download it again");
    }
    report.format = "STL (text)";
    prepare_text(bytes, file);
    soup = TextStl(bytes.view(), file).read();
  }
  number_corners(soup, file);
  return to_mesh(std::move(soup), file, report);
}

}  // namespace verdigris::io
