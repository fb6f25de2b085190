#pragma once
// What of a glTF file makes its geometry, checked before tinygltf sees it.

#include <filesystem>
#include <string>
#include <string_view>

namespace verdigris::io {

/// A glTF file with nothing left in it but scenes, nodes, meshes, accessors, views and buffers.
struct GltfGeometry {
  std::string json;       ///< for .gltf
  std::string glb;        ///< the whole file again, for .glb
  std::size_t bytes = 0;  ///< of the file and of what it refers to
};

/// Takes `bytes` apart. Throws InputError for JSON that is malformed or nested too deeply, required
/// extensions and compressed geometry that are not read here, URIs that are absolute, lead out of the file's
/// directory or to no regular file, and buffers shorter than they claim.
GltfGeometry check_gltf(std::string_view bytes, const std::filesystem::path& file);

}  // namespace verdigris::io
