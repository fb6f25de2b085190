#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/matrix.hpp>

#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/function_system.hpp"

namespace verdigris {

namespace {

constexpr const char* form =
    "write 6 numbers a b c d e f for (a x + b y + e, c x + d y + f), or 12 in space: three rows of three "
    "factors and an offset; one more is the weight";
constexpr std::size_t most_maps = 1000;
constexpr double most_offset = 1e6;

class MapParser {
 public:
  MapParser(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  FunctionSystem parse() {
    FunctionSystem system;
    std::vector<double> numbers;
    std::size_t begin = 0;
    for (at_ = 0; at_ <= text_.size(); ++at_) {
      const char c = at_ < text_.size() ? text_[at_] : '\n';
      if (c == '\n' || c == ';') {
        if (!numbers.empty()) add(system, numbers, begin);
        numbers.clear();
      } else if (c == '#') {
        while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
      } else if (c != ' ' && c != '\t' && c != ',' && c != '\r') {
        if (numbers.empty()) begin = at_;
        if (numbers.size() == 13) fault(at_, "too many numbers for one map", form);
        numbers.push_back(number());
      }
    }
    if (system.maps.empty()) throw InputError(where_, "there are no maps", form);
    // Without weights: by the size of the images, those of no size a little.
    double sum = 0.0;
    for (const AffineMap& map : system.maps) sum += size_of(map, system.dimension);
    for (AffineMap& map : system.maps)
      if (map.weight == 0.0)
        map.weight = std::max(size_of(map, system.dimension), sum > 0.0 ? 0.01 * sum : 1.0);
    return system;
  }

 private:
  [[noreturn]] void fault(std::size_t at, std::string problem, std::string remedy) const {
    const std::string_view before = text_.substr(0, at);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t column = at - (before.rfind('\n') + 1) + 1;
    throw InputError(fmt::format("{}:{}:{}", where_, line, column), std::move(problem), std::move(remedy));
  }

  double number() {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) fault(at_, "this is no number", form);
    at_ = static_cast<std::size_t>(end - text_.data()) - 1;
    return value;
  }

  static double size_of(const AffineMap& map, int dimension) {
    const glm::dmat3& m = map.linear;
    return std::abs(dimension == 3 ? glm::determinant(m) : m[0][0] * m[1][1] - m[1][0] * m[0][1]);
  }

  void add(FunctionSystem& system, const std::vector<double>& n, std::size_t at) const {
    const bool flat = n.size() == 6 || n.size() == 7;
    if (!flat && n.size() != 12 && n.size() != 13)
      fault(at, fmt::format("{} numbers for one map", n.size()), form);
    if (!system.maps.empty() && flat != (system.dimension == 2))
      fault(at, "maps of the plane and of space in one system", form);
    if (system.maps.size() == most_maps)
      fault(at, "too many maps", fmt::format("give at most {}", most_maps));
    system.dimension = flat ? 2 : 3;
    AffineMap map;
    if (flat) {
      map.linear = glm::dmat3(n[0], n[2], 0, n[1], n[3], 0, 0, 0, 0);
      map.offset = {n[4], n[5], 0};
    } else {
      map.linear = glm::dmat3(n[0], n[4], n[8], n[1], n[5], n[9], n[2], n[6], n[10]);
      map.offset = {n[3], n[7], n[11]};
    }
    const bool weighted = n.size() == 7 || n.size() == 13;
    if (weighted && !(n.back() > 0.0))
      fault(at, fmt::format("weight {} is not positive", n.back()), "give a weight greater than 0");
    map.weight = weighted ? n.back() : 0.0;
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(map.offset[k]) <= most_offset))
        fault(at, fmt::format("the map moves points by {}", map.offset[k]),
              fmt::format("give offsets of at most {}", most_offset));
    const double s = stretch(map.linear);
    if (!(s < 0.999))
      fault(at, fmt::format("the map stretches lengths by up to {:.4g}", s),
            "only contractions have an attractor: use smaller factors");
    system.maps.push_back(map);
  }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 0;
};

// The 20 cubes of 27 that have at most one coordinate in the middle.
std::string menger_maps() {
  std::string text;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
        if ((x == 1) + (y == 1) + (z == 1) < 2)
          text +=
              fmt::format("{0} 0 0 {1}  0 {0} 0 {2}  0 0 {0} {3}\n", 1.0 / 3.0, x / 3.0, y / 3.0, z / 3.0);
  return text;
}

constexpr const char* names[] = {"sierpinski-triangle", "sierpinski-tetrahedron", "menger-sponge",
                                 "barnsley-fern"};

}  // namespace

FunctionSystem parse_function_system(std::string_view text, const std::string& where) {
  return MapParser(text, where).parse();
}

std::span<const char* const> function_system_names() {
  return names;
}

FunctionSystem named_function_system(std::string_view name) {
  const char* text = nullptr;
  if (name == names[0])  // corners (0, 0), (1, 0), (1/2, sqrt(3)/2)
    text = "0.5 0 0 0.5 0 0; 0.5 0 0 0.5 0.5 0; 0.5 0 0 0.5 0.25 0.4330127018922193";
  else if (name == names[1])  // corners of the unit cube, every second
    text =
        ".5 0 0 0  0 .5 0 0  0 0 .5 0; .5 0 0 .5  0 .5 0 .5  0 0 .5 0; .5 0 0 .5  0 .5 0 0  0 0 .5 .5;"
        ".5 0 0 0  0 .5 0 .5  0 0 .5 .5";
  else if (name == names[2])
    return parse_function_system(menger_maps(), names[2]);
  else if (name == names[3])  // Fractals Everywhere, table III.3
    text =
        "0 0 0 0.16 0 0 0.01; 0.85 0.04 -0.04 0.85 0 1.6 0.85; 0.2 -0.26 0.23 0.22 0 1.6 0.07;"
        "-0.15 0.28 0.26 0.24 0 0.44 0.07";
  else
    throw InputError("function system", fmt::format("there is none named '{}'", name),
                     fmt::format("choose one of: {}", fmt::join(names, ", ")));
  return parse_function_system(text, std::string(name));
}

}  // namespace verdigris
