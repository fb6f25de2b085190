#include "cells_file.hpp"

#include <cstring>
#include <glm/geometric.hpp>
#include <sstream>
#include <stdexcept>

#include "program.hpp"

namespace {

template <typename T>
std::vector<T> appended(const std::string& file, const std::string& type, const std::string& name) {
  const std::size_t tag = file.find("<DataArray type=\"" + type + "\" Name=\"" + name + "\"");
  const std::string begin = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t data = file.find(begin);
  if (tag == std::string::npos || data == std::string::npos)
    throw std::runtime_error("no " + type + " array " + name);
  const std::size_t offset = file.find("offset=\"", tag) + 8;
  const std::size_t at = data + begin.size() + std::stoull(file.substr(offset));
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, file.data() + at, sizeof bytes);
  if (at + sizeof bytes + bytes > file.size()) throw std::runtime_error("array " + name + " is cut off");
  std::vector<T> values(bytes / sizeof(T));
  std::memcpy(values.data(), file.data() + at + sizeof bytes, bytes);
  return values;
}

}  // namespace

std::size_t CellsFile::nearest(glm::dvec3 point) const {
  std::size_t best = 0;
  for (std::size_t k = 1; k < points.size(); ++k)
    if (glm::distance(points[k], point) < glm::distance(points[best], point)) best = k;
  return best;
}

CellsFile read_cells(const std::filesystem::path& file) {
  const std::string text = content_of(file);
  CellsFile cells{appended<std::int32_t>(text, "Int32", "label"),
                  appended<std::int32_t>(text, "Int32", "arrival"),
                  appended<std::int32_t>(text, "Int32", "patch"), appended<double>(text, "Float64", "area"),
                  appended<glm::dvec3>(text, "Float64", "Points")};
  const std::size_t n = cells.points.size();
  if (n == 0 || cells.label.size() != n || cells.arrival.size() != n || cells.patch.size() != n ||
      cells.area.size() != n)
    throw std::runtime_error("arrays of different length");
  return cells;
}

std::vector<glm::dvec3> points_of(const std::filesystem::path& file) {
  return appended<glm::dvec3>(content_of(file), "Float64", "Points");
}

std::vector<float> floats_of(const std::filesystem::path& file, const std::string& name) {
  return appended<float>(content_of(file), "Float32", name);
}

std::vector<std::vector<double>> read_table(const std::filesystem::path& file) {
  std::istringstream lines(content_of(file));
  std::vector<std::vector<double>> table;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    table.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) table.back().push_back(std::stod(field));
  }
  return table;
}
