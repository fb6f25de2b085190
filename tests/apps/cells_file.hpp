#pragma once
// cells.vtp and the tables, read back.

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

struct CellsFile {
  std::vector<std::int32_t> label, arrival, patch;
  std::vector<double> area;
  std::vector<glm::dvec3> points;

  std::size_t nearest(glm::dvec3 point) const;
};

/// Throws std::runtime_error for anything but the arrays that verdigris voronoi writes.
CellsFile read_cells(const std::filesystem::path& file);

/// The centres of the cells, and an array of numbers beside them. Throw std::runtime_error when the file has
/// none.
std::vector<glm::dvec3> points_of(const std::filesystem::path& file);
std::vector<float> floats_of(const std::filesystem::path& file, const std::string& name);

/// The rows of a table of numbers, without its header line.
std::vector<std::vector<double>> read_table(const std::filesystem::path& file);
