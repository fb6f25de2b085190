#include "gltf_accessor.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "binary_numbers.hpp"
#include "file_bytes.hpp"
#include "text_numbers.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris::io {

namespace {

/// A checked stretch of a buffer, from which elements can be read.
struct Stretch {
  const char* data;
  std::size_t stride;
};

class AccessorReader {
 public:
  AccessorReader(const tinygltf::Model& model, int index, std::size_t most, const std::filesystem::path& file)
      : model_(model), index_(index), most_(most), file_(file) {}

  GltfNumbers read() {
    if (index_ < 0 || static_cast<std::size_t>(index_) >= model_.accessors.size())
      stop(fmt::format("is not there (the file has {})", model_.accessors.size()));
    const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index_)];
    if (accessor.type != TINYGLTF_TYPE_SCALAR &&
        (accessor.type < TINYGLTF_TYPE_VEC2 || accessor.type > TINYGLTF_TYPE_VEC4))
      stop("is neither of numbers nor of vectors");

    GltfNumbers numbers;
    numbers.count = accessor.count;
    numbers.components = accessor.type == TINYGLTF_TYPE_SCALAR ? 1 : static_cast<std::size_t>(accessor.type);
    numbers.whole =
        !accessor.normalized && (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                 accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                 accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    const std::size_t size = width(accessor.componentType);
    if (numbers.count > most_ / numbers.components)
      stop(fmt::format("claims {} elements, more than the file can hold", numbers.count));
    const bool has_view = accessor.bufferView >= 0;
    Stretch from{};
    if (has_view)
      from =
          stretch(accessor.bufferView, accessor.byteOffset, numbers.count, size * numbers.components, size);
    numbers.values.resize(numbers.count * numbers.components);  // zero where there is no view
    if (has_view)
      for (std::size_t i = 0; i < numbers.count; ++i)
        read_element(accessor, numbers, i, from.data + i * from.stride);
    if (accessor.sparse.isSparse) read_sparse(accessor, numbers, size);
    return numbers;
  }

 private:
  [[noreturn]] void stop(const std::string& problem) const {
    throw InputError(shown(file_), fmt::format("accessor {} {}", index_, problem),
                     "the file may have been cut off or damaged: export or download it again");
  }

  std::size_t width(int component_type) const {
    switch (component_type) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
      case TINYGLTF_COMPONENT_TYPE_SHORT:
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
      default:
        stop(fmt::format("has the component type {}, which glTF does not know", component_type));
    }
  }

  /// `count` elements of `size` bytes from `offset` of a view on. All sums are of numbers already known to be
  /// small.
  Stretch stretch(int view_index, std::size_t offset, std::size_t count, std::size_t size,
                  std::size_t width) const {
    if (view_index < 0 || static_cast<std::size_t>(view_index) >= model_.bufferViews.size())
      stop(fmt::format("refers to buffer view {} of {}", view_index, model_.bufferViews.size()));
    const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size())
      stop(fmt::format("refers to buffer {} of {}", view.buffer, model_.buffers.size()));
    const std::vector<unsigned char>& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
      stop(fmt::format("uses a buffer view that ends behind its buffer of {} bytes", data.size()));
    const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
    if (stride < size || stride > 255 || stride % width != 0)
      stop(fmt::format("has elements of {} bytes every {} bytes", size, stride));
    const bool fits = count == 0 || (offset <= view.byteLength && size <= view.byteLength - offset &&
                                     count - 1 <= (view.byteLength - offset - size) / stride);
    if (!fits) stop(fmt::format("ends behind its buffer view of {} bytes", view.byteLength));
    return {reinterpret_cast<const char*>(data.data()) + view.byteOffset + offset, stride};
  }

  void read_element(const tinygltf::Accessor& accessor, GltfNumbers& to, std::size_t element,
                    const char* from) const {
    for (std::size_t c = 0; c < to.components; ++c) {
      double& value = to.values[element * to.components + c];
      double largest = 1.0;
      switch (accessor.componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
          value = load<std::int8_t>(from + c, false);
          largest = 127.0;
          break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
          value = load<std::uint8_t>(from + c, false);
          largest = 255.0;
          break;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
          value = load<std::int16_t>(from + 2 * c, false);
          largest = 32767.0;
          break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
          value = load<std::uint16_t>(from + 2 * c, false);
          largest = 65535.0;
          break;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
          value = load<std::uint32_t>(from + 4 * c, false);
          break;
        default:
          value = load<float>(from + 4 * c, false);
          if (!std::isfinite(value))
            throw InputError(shown(file_),
                             fmt::format("element {} of accessor {} is not finite", element, index_),
                             remedy_not_finite);
      }
      if (accessor.normalized) value = std::max(value / largest, -1.0);
    }
  }

  void read_sparse(const tinygltf::Accessor& accessor, GltfNumbers& numbers, std::size_t size) const {
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > numbers.count ||
        sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
      stop("has sparse entries of impossible number or place");
    const auto count = static_cast<std::size_t>(sparse.count);
    const std::size_t index_size = width(sparse.indices.componentType);
    const Stretch places =
        stretch(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
                index_size, index_size);
    const Stretch values =
        stretch(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
                size * numbers.components, size);
    for (std::size_t i = 0; i < count; ++i) {
      const char* from = places.data + i * places.stride;
      const std::size_t place = index_size == 1   ? load<std::uint8_t>(from, false)
                                : index_size == 2 ? load<std::uint16_t>(from, false)
                                                  : load<std::uint32_t>(from, false);
      if (place >= numbers.count)
        stop(fmt::format("has a sparse entry for element {} of {}", place, numbers.count));
      read_element(accessor, numbers, place, values.data + i * values.stride);
    }
  }

  const tinygltf::Model& model_;
  int index_;
  std::size_t most_;
  const std::filesystem::path& file_;
};

}  // namespace

GltfNumbers read_accessor(const tinygltf::Model& model, int index, std::size_t most,
                          const std::filesystem::path& file) {
  return AccessorReader(model, index, most, file).read();
}

}  // namespace verdigris::io
