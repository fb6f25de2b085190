#include "verdigris/io/write_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <iterator>
#include <string>

#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"

namespace verdigris {

namespace {

// One array of VTK's appended data, and all before it.
class AppendedData {
 public:
  template <typename T>
  std::string add(const char* type, const char* name, int components, const std::vector<T>& values) {
    const std::string xml = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        type, name, components, bytes_.size());
    const std::uint64_t size = values.size() * sizeof(T);
    append(&size, sizeof size);
    append(values.data(), static_cast<std::size_t>(size));
    return xml;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  std::string bytes_;
};

}  // namespace

void write_lines_vtp(const std::filesystem::path& target, std::span<const Polyline> lines) {
  std::vector<glm::dvec3> points;
  std::vector<double> widths;
  std::vector<std::int32_t> triangles, generations;
  std::vector<std::int64_t> connectivity, offsets;
  for (const Polyline& line : lines) {
    points.insert(points.end(), line.points.begin(), line.points.end());
    widths.insert(widths.end(), line.widths.begin(), line.widths.end());
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      triangles.push_back(line.triangles.empty() ? -1 : line.triangles[k]);
      connectivity.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
    offsets.push_back(static_cast<std::int64_t>(points.size()));
    generations.push_back(line.generation);
  }
  AppendedData data;
  const std::string point_data =
      data.add("Float64", "width", 1, widths) + data.add("Int32", "triangle", 1, triangles);
  const std::string cell_data = data.add("Int32", "generation", 1, generations);
  static_assert(sizeof(glm::dvec3) == 24);
  const std::string xml_points = data.add("Float64", "Points", 3, points);
  const std::string xml_lines =
      data.add("Int64", "connectivity", 1, connectivity) + data.add("Int64", "offsets", 1, offsets);
  ReplaceFile file(target);
  file.write(fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
      "NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n<PointData>\n{}</PointData>\n<CellData>\n{}</CellData>\n<Points>\n{}</Points>\n"
      "<Lines>\n{}</Lines>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_",
      points.size(), lines.size(), point_data, cell_data, xml_points, xml_lines));
  file.write(data.bytes());
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

void write_lines_obj(const std::filesystem::path& target, std::span<const Polyline> lines) {
  ReplaceFile file(target);
  std::string text;
  for (const Polyline& line : lines)
    for (const glm::dvec3& p : line.points) {
      fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x, p.y, p.z);
      if (text.size() > 60000) {
        file.write(text);
        text.clear();
      }
    }
  std::size_t vertex = 1;
  for (const Polyline& line : lines) {
    text += 'l';
    for (std::size_t k = 0; k < line.points.size(); ++k)
      fmt::format_to(std::back_inserter(text), " {}", vertex++);
    text += '\n';
    if (text.size() > 60000) {
      file.write(text);
      text.clear();
    }
  }
  file.write(text);
  file.commit();
}

void write_lines_svg(const std::filesystem::path& target, std::span<const Polyline> lines) {
  glm::dvec3 low(0.0), high(0.0);
  double widest = 0.0;
  bool any = false;
  for (const Polyline& line : lines)
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      low = any ? glm::min(low, line.points[k]) : line.points[k];
      high = any ? glm::max(high, line.points[k]) : line.points[k];
      widest = std::max(widest, line.widths[k]);
      any = true;
    }
  const double extent = std::max(high.x - low.x, high.y - low.y) + widest;
  const double scale = extent > 0.0 ? 1000.0 / extent : 1.0;
  const auto x = [&](const glm::dvec3& p) { return (p.x - low.x + 0.5 * widest) * scale; };
  const auto y = [&](const glm::dvec3& p) { return (high.y - p.y + 0.5 * widest) * scale; };
  ReplaceFile file(target);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.2f} {:.2f}\" fill=\"none\" "
      "stroke=\"#1d4d43\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
      (high.x - low.x + widest) * scale, (high.y - low.y + widest) * scale);
  for (const Polyline& line : lines)
    // A path for each run of one width.
    for (std::size_t k = 1; k < line.points.size();) {
      const double width = line.widths[k];
      fmt::format_to(std::back_inserter(text), "<path stroke-width=\"{:.3f}\" d=\"M{:.3f} {:.3f}",
                     width * scale, x(line.points[k - 1]), y(line.points[k - 1]));
      for (; k < line.points.size() && line.widths[k] == width; ++k)
        fmt::format_to(std::back_inserter(text), "L{:.3f} {:.3f}", x(line.points[k]), y(line.points[k]));
      text += "\"/>\n";
      if (text.size() > 60000) {
        file.write(text);
        text.clear();
      }
    }
  file.write(text + "</svg>\n");
  file.commit();
}

}  // namespace verdigris
