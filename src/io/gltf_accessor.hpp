#pragma once
// Numbers out of a glTF accessor, with every index, view and range checked: tinygltf checks none.

#include <filesystem>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace verdigris::io {

/// The elements of an accessor, normalised where it says so, sparse entries put in.
struct GltfNumbers {
  std::size_t count = 0;       ///< elements
  std::size_t components = 0;  ///< numbers an element
  bool whole = false;          ///< stored as unsigned whole numbers
  std::vector<double> values;

  double at(std::size_t element, std::size_t component) const {
    return values[element * components + component];
  }
};

/// Reads accessor `index`. Throws InputError naming `file` and the accessor when it or what it refers to is
/// not there, or would take more than `most` numbers.
GltfNumbers read_accessor(const tinygltf::Model& model, int index, std::size_t most,
                          const std::filesystem::path& file);

}  // namespace verdigris::io
