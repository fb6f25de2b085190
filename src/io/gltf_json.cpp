#include "gltf_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "binary_numbers.hpp"
#include "file_bytes.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris::io {

namespace {

using nlohmann::json;

constexpr int deepest =
    64;  // core glTF needs about ten; recursive parsers overflow the stack at some ten thousands
constexpr char remedy_damaged[] = "the file may have been cut off or damaged: export or download it again";

[[noreturn]] void stop(const std::filesystem::path& file, const std::string& problem, const char* remedy) {
  throw InputError(shown(file), problem, remedy);
}

/// The two chunks of a binary file.
struct Chunks {
  std::string_view text, binary;
};

Chunks split(std::string_view bytes, const std::filesystem::path& file) {
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  auto word = [&](std::size_t at) {
    if (at + 4 > bytes.size())
      stop(file, fmt::format("the file ends inside a header, at byte {}", at), remedy_damaged);
    return std::size_t{load<std::uint32_t>(bytes.data() + at, false)};
  };
  if (word(4) != 2)
    stop(file, fmt::format("version {} of binary glTF is not read", word(4)), "export it as glTF 2.0");
  const std::size_t length = word(8);
  if (length > bytes.size() || length < 20)
    stop(file, fmt::format("the file announces {} bytes and has {}", length, bytes.size()), remedy_damaged);
  Chunks chunks;
  for (std::size_t at = 12; at + 8 <= length;) {
    const std::size_t size = word(at), kind = word(at + 4);
    if (size > length - at - 8)
      stop(file, fmt::format("the chunk at byte {} is longer than the file", at), remedy_damaged);
    const std::string_view data = bytes.substr(at + 8, size);
    if (kind == 0x4E4F534A && chunks.text.empty()) chunks.text = data;      // "JSON"
    if (kind == 0x004E4942 && chunks.binary.empty()) chunks.binary = data;  // "BIN"
    at += 8 + size;
  }
  return chunks;
}

json parse(std::string_view text, const std::filesystem::path& file) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  auto shallow = [&file](int depth, json::parse_event_t, json&) {
    if (depth > deepest)
      stop(file, fmt::format("the JSON is nested more than {} deep", deepest),
           "this is no glTF: export the model again");
    return true;
  };
  try {
    json parsed = json::parse(text, shallow);
    if (parsed.is_object()) return parsed;
  } catch (const json::exception& e) {
    stop(file, fmt::format("the JSON is malformed ({})", e.what()), remedy_damaged);
  }
  stop(file, "the JSON is not an object", "check that the file is a glTF model");
}

/// The array `name` of `in`, or an empty one. Its entries are objects.
const json& objects(const json& in, const char* name, const std::filesystem::path& file) {
  static const json none = json::array();
  const auto found = in.find(name);
  if (found == in.end()) return none;
  const bool good = found->is_array() &&
                    std::all_of(found->begin(), found->end(), [](const json& e) { return e.is_object(); });
  if (!good) stop(file, fmt::format("'{}' is not a list of objects", name), remedy_damaged);
  return *found;
}

bool has_extension(const json& in, const char* name) {
  const auto extensions = in.find("extensions");
  return extensions != in.end() && extensions->is_object() && extensions->contains(name);
}

void check_extensions(const json& root, const std::filesystem::path& file) {
  if (const auto required = root.find("extensionsRequired"); required != root.end()) {
    if (!required->is_array()) stop(file, "'extensionsRequired' is not a list", remedy_damaged);
    for (const json& e : *required) {
      const std::string name = e.is_string() ? e.get<std::string>() : "?";
      // What changes only how the surface looks may be passed over.
      const bool harmless = name == "KHR_mesh_quantization" || name == "KHR_texture_transform" ||
                            name == "KHR_lights_punctual" || name.starts_with("KHR_materials_") ||
                            name == "KHR_texture_basisu" || name.starts_with("EXT_texture_");
      if (!harmless)
        stop(file, fmt::format("the file requires the extension '{}', which is not read here", name),
             "export again without compression and without this extension");
    }
  }
  static constexpr char remedy[] = "export again without compression of geometry and without instancing";
  for (const json& mesh : objects(root, "meshes", file))
    for (const json& primitive : objects(mesh, "primitives", file))
      if (has_extension(primitive, "KHR_draco_mesh_compression"))
        stop(file, "the geometry is compressed with Draco (KHR_draco_mesh_compression)", remedy);
  for (const json& view : objects(root, "bufferViews", file))
    if (has_extension(view, "EXT_meshopt_compression") || has_extension(view, "KHR_meshopt_compression"))
      stop(file, "the geometry is compressed with meshoptimizer (EXT_meshopt_compression)", remedy);
  for (const json& node : objects(root, "nodes", file))
    if (has_extension(node, "EXT_mesh_gpu_instancing"))
      stop(file, "the file draws many copies of a mesh (EXT_mesh_gpu_instancing)", remedy);
}

/// `uri` with %xx resolved.
std::string decoded(std::string_view uri) {
  auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10 : -1;
  };
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    text += escape ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i];
    if (escape) i += 2;
  }
  return text;
}

void check_stays_inside(const std::string& path, const std::filesystem::path& file) {
  bool leads_out = path.empty() || path[0] == '/' || path[0] == '\\' || path[0] == '~' ||
                   path.find_first_of(std::string_view(":\0", 2)) != std::string::npos;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find_first_of("/\\", from), path.size());
    leads_out = leads_out || path.substr(from, to - from) == "..";
    from = to + 1;
  }
  if (leads_out)
    stop(file, fmt::format("the buffer '{}' is not beside the file", path),
         "put the .bin file into the directory of the .gltf file, or export as .glb");
}

/// Checks every buffer's source and size; returns the bytes outside the file itself.
std::size_t check_buffers(const json& root, std::size_t binary_bytes, const std::filesystem::path& file) {
  std::set<std::string> seen;
  std::size_t outside = 0, number = 0;
  for (const json& buffer : objects(root, "buffers", file)) {
    const auto length = buffer.find("byteLength");
    if (length == buffer.end() || !length->is_number_unsigned() || length->get<std::uint64_t>() == 0)
      stop(file, fmt::format("buffer {} has no valid byteLength", number), remedy_damaged);
    const auto claimed = length->get<std::uint64_t>();
    const auto uri = buffer.find("uri");
    std::size_t there = 0;
    if (uri == buffer.end()) {
      there = number == 0 ? binary_bytes : 0;
    } else if (!uri->is_string()) {
      stop(file, fmt::format("the URI of buffer {} is not a string", number), remedy_damaged);
    } else if (const auto& text = uri->get_ref<const std::string&>(); text.starts_with("data:")) {
      static constexpr std::array prefixes{"data:application/octet-stream;base64,",
                                           "data:application/gltf-buffer;base64,"};
      if (std::none_of(prefixes.begin(), prefixes.end(), [&](const char* p) { return text.starts_with(p); }))
        stop(file, fmt::format("the data URI of buffer {} is not base64 of application/octet-stream", number),
             "export as .glb");
      there = (text.size() - text.find(',')) / 4 * 3 + 3;
    } else {
      const std::string path = decoded(text);
      check_stays_inside(path, file);
      if (!seen.insert(path).second)
        stop(file, fmt::format("two buffers are the same file '{}'", path),
             "export as .glb, or into one buffer");
      try {
        there = read_file(file.parent_path() / path).size();
      } catch (const InputError& e) {
        throw InputError(shown(file), fmt::format("its buffer '{}': {}", path, e.problem()), e.remedy());
      }
      outside += there;
    }
    if (claimed > there)
      stop(file, fmt::format("buffer {} claims {} bytes and has at most {}", number, claimed, there),
           remedy_damaged);
    ++number;
  }
  return outside;
}

/// Everything but geometry goes: images above all, which tinygltf trusts too much.
json only_geometry(const json& root, const std::filesystem::path& file) {
  json out = json::object();
  for (const char* name :
       {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers"})
    if (const auto found = root.find(name); found != root.end()) out[name] = *found;
  for (const char* name : {"scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers"}) {
    objects(out, name, file);  // all are lists of objects, or this throws
    if (!out.contains(name)) continue;
    for (json& e : out[name])
      for (const char* drop : {"extensions", "extras", "name", "camera", "weights"}) e.erase(drop);
  }
  if (out.contains("meshes"))
    for (json& mesh : out["meshes"]) {
      objects(mesh, "primitives", file);
      if (!mesh.contains("primitives")) continue;
      for (json& primitive : mesh["primitives"])
        for (const char* drop : {"extensions", "extras", "material", "targets"}) primitive.erase(drop);
    }
  return out;
}

void append_word(std::string& to, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8) to += static_cast<char>(value >> shift & 255);
}

}  // namespace

GltfGeometry check_gltf(std::string_view bytes, const std::filesystem::path& file) {
  const Chunks chunks = split(bytes, file);
  const json root = parse(chunks.text, file);
  const auto asset = root.find("asset");
  const bool version_2 = asset != root.end() && asset->is_object() && asset->contains("version") &&
                         (*asset)["version"].is_string() &&
                         (*asset)["version"].get<std::string>().starts_with("2.");
  if (!version_2) stop(file, "the file does not say that it is glTF 2", "export it as glTF 2.0");
  check_extensions(root, file);

  GltfGeometry geometry;
  geometry.bytes = bytes.size() + check_buffers(root, chunks.binary.size(), file);
  geometry.json = only_geometry(root, file).dump(-1, ' ', false, json::error_handler_t::replace);
  if (bytes.starts_with("glTF")) {
    std::string text = geometry.json;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t padding = (4 - chunks.binary.size() % 4) % 4;
    const std::size_t binary = chunks.binary.size() + padding;
    geometry.glb = "glTF";
    append_word(geometry.glb, 2);
    append_word(geometry.glb, 12 + 8 + text.size() + (binary ? 8 + binary : 0));
    append_word(geometry.glb, text.size());
    geometry.glb += "JSON" + text;
    if (binary) {
      append_word(geometry.glb, binary);
      geometry.glb += std::string("BIN\0", 4);
      geometry.glb += chunks.binary;
      geometry.glb.append(padding, '\0');
    }
  }
  return geometry;
}

}  // namespace verdigris::io
