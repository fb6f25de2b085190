// glTF 2.0, text and binary, through tinygltf: every triangle that the scene shows, where its nodes put it.

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <memory>

#include "formats.hpp"
#include "gltf_accessor.hpp"
#include "gltf_json.hpp"
#include "polygon_soup.hpp"
#include "text_cursor.hpp"
#include "text_numbers.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris::io {

namespace {

constexpr char remedy_damaged[] = "the file may have been cut off or damaged: export or download it again";

bool exists(const std::string& path, void*) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

/// tinygltf's own would hand the path to a shell's expansion.
std::string same_path(const std::string& path, void*) {
  return path;
}

bool read_whole(std::vector<unsigned char>* out, std::string* error, const std::string& path, void*) {
  try {
    const FileBytes bytes = read_file(path);
    out->assign(bytes.view().begin(), bytes.view().end());
    return true;
  } catch (const InputError& e) {
    *error += e.problem();
    return false;
  }
}

bool no_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
              void*) {
  return true;
}

/// The model is large, and not cheap to move in this version.
std::unique_ptr<tinygltf::Model> load_model(const GltfGeometry& geometry, const std::filesystem::path& file) {
  auto model = std::make_unique<tinygltf::Model>();
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(no_image, nullptr);
  loader.SetFsCallbacks({exists, same_path, read_whole, nullptr, nullptr});
  std::string error, warning;
  const std::string directory = file.has_parent_path() ? file.parent_path().string() : ".";
  const std::string& source = geometry.glb.empty() ? geometry.json : geometry.glb;
  if (source.size() > 0xFFFFFFFFu)
    throw InputError(shown(file), "the file is larger than 4 GiB", "split the model");
  const auto size = static_cast<unsigned int>(source.size());
  bool loaded = false;
  try {
    loaded = geometry.glb.empty()
                 ? loader.LoadASCIIFromString(model.get(), &error, &warning, source.data(), size, directory)
                 : loader.LoadBinaryFromMemory(model.get(), &error, &warning,
                                               reinterpret_cast<const unsigned char*>(source.data()), size,
                                               directory);
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    error += e.what();
  }
  if (!loaded || !error.empty()) {
    for (char& c : error)
      if (c == '\n') c = ' ';
    throw InputError(shown(file),
                     fmt::format("tinygltf cannot read it: {}", error.empty() ? "no reason given" : error),
                     remedy_damaged);
  }
  return model;
}

glm::dmat4 local_transform(const tinygltf::Node& node, std::size_t number,
                           const std::filesystem::path& file) {
  auto fits = [](const std::vector<double>& v, std::size_t n) { return v.empty() || v.size() == n; };
  if (!fits(node.matrix, 16) || !fits(node.translation, 3) || !fits(node.rotation, 4) || !fits(node.scale, 3))
    throw InputError(shown(file), fmt::format("the transform of node {} is malformed", number),
                     remedy_damaged);
  if (!node.matrix.empty()) {
    glm::dmat4 m;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) m[c][r] = node.matrix[static_cast<std::size_t>(4 * c + r)];
    return m;
  }
  glm::dmat4 m(1.0);
  if (!node.rotation.empty()) {
    const glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    if (glm::dot(q, q) > 0.0) m = glm::mat4_cast(glm::normalize(q));
  }
  if (!node.scale.empty())
    for (int c = 0; c < 3; ++c) m[c] *= node.scale[static_cast<std::size_t>(c)];
  if (!node.translation.empty())
    m[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
  return m;
}

class SceneReader {
 public:
  /// A scene may show one mesh many times, so what comes out is bounded by this many numbers for the file's
  /// bytes.
  SceneReader(const tinygltf::Model& model, std::size_t bytes, const std::filesystem::path& file)
      : model_(model), most_(std::max<std::size_t>(16 * bytes, 1 << 20)), file_(file) {}

  PolygonSoup read() {
    std::vector<int> roots;
    if (!model_.scenes.empty()) {
      const int chosen = model_.defaultScene < 0 ? 0 : model_.defaultScene;
      if (static_cast<std::size_t>(chosen) >= model_.scenes.size())
        stop(fmt::format("the scene {} is not there (the file has {})", chosen, model_.scenes.size()));
      roots = model_.scenes[static_cast<std::size_t>(chosen)].nodes;
    } else {
      roots = parentless();
    }
    show(roots);
    if (!any_uv_) soup_.vertex_uv.clear();
    if (!any_color_) soup_.vertex_color.clear();
    return std::move(soup_);
  }

 private:
  [[noreturn]] void stop(const std::string& problem) const {
    throw InputError(shown(file_), problem, remedy_damaged);
  }

  std::vector<int> parentless() const {
    std::vector<bool> child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes)
      for (const int c : node.children)
        if (c >= 0 && static_cast<std::size_t>(c) < child.size()) child[static_cast<std::size_t>(c)] = true;
    std::vector<int> roots;
    for (std::size_t n = 0; n < child.size(); ++n)
      if (!child[n]) roots.push_back(static_cast<int>(n));
    return roots;
  }

  /// Walks the tree of nodes without recursion, in the file's order; a node met twice is a cycle or has two
  /// parents.
  void show(const std::vector<int>& roots) {
    struct Visit {
      int node;
      glm::dmat4 parent;
    };
    std::vector<Visit> todo;
    for (auto r = roots.rbegin(); r != roots.rend(); ++r) todo.push_back({*r, glm::dmat4(1.0)});
    std::vector<bool> seen(model_.nodes.size(), false);
    while (!todo.empty()) {
      const Visit visit = todo.back();
      todo.pop_back();
      const auto number = static_cast<std::size_t>(visit.node);
      if (visit.node < 0 || number >= seen.size())
        stop(fmt::format("node {} is not there (the file has {})", visit.node, seen.size()));
      if (seen[number]) stop(fmt::format("node {} is reached twice: the nodes are not a tree", visit.node));
      seen[number] = true;
      const tinygltf::Node& node = model_.nodes[number];
      const glm::dmat4 world = visit.parent * local_transform(node, number, file_);
      // A skinned mesh stands where its joints are; at rest that is where it was modelled.
      if (node.mesh != -1) show_mesh(node.mesh, node.skin >= 0 ? glm::dmat4(1.0) : world);
      for (auto c = node.children.rbegin(); c != node.children.rend(); ++c) todo.push_back({*c, world});
    }
  }

  void show_mesh(int index, const glm::dmat4& world) {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.meshes.size())
      stop(fmt::format("mesh {} is not there (the file has {})", index, model_.meshes.size()));
    for (const tinygltf::Primitive& primitive : model_.meshes[static_cast<std::size_t>(index)].primitives) {
      const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
      if (mode > TINYGLTF_MODE_TRIANGLE_FAN) stop(fmt::format("{} is not a way to draw", mode));
      if (mode >= TINYGLTF_MODE_TRIANGLES)
        show_primitive(primitive, mode, world);  // points and lines have no surface
    }
  }

  GltfNumbers numbers(int accessor) {
    GltfNumbers n = read_accessor(model_, accessor, most_ - std::min(most_, used_), file_);
    used_ += n.values.size();
    return n;
  }

  void show_primitive(const tinygltf::Primitive& primitive, int mode, const glm::dmat4& world) {
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return;
    const GltfNumbers points = numbers(position->second);
    if (points.components != 3) stop("positions are not vectors of three");
    const std::size_t first = soup_.positions.size();
    if (first + points.count >= PolygonSoup::none)
      throw InputError(shown(file_), "too many vertices", remedy_too_many);
    for (std::size_t v = 0; v < points.count; ++v) {
      const glm::dvec3 p(world * glm::dvec4(points.at(v, 0), points.at(v, 1), points.at(v, 2), 1.0));
      const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      if (!(size <= largest_number) || std::isnan(p.x + p.y + p.z))
        throw InputError(shown(file_),
                         "a node's transform makes coordinates that are not finite, or too large",
                         remedy_too_large);
      soup_.positions.push_back(p);
    }
    take_attributes(primitive, points.count);

    std::vector<std::uint32_t> order;
    if (primitive.indices != -1) {
      const GltfNumbers indices = numbers(primitive.indices);
      if (indices.components != 1 || !indices.whole) stop("indices are not unsigned whole numbers");
      order.reserve(indices.count);
      for (const double i : indices.values) {
        if (i >= static_cast<double>(points.count))
          stop(fmt::format("index {} points to no vertex (there are {})", i, points.count));
        order.push_back(static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(i));
      }
    } else {
      for (std::size_t v = 0; v < points.count; ++v) order.push_back(static_cast<std::uint32_t>(first + v));
    }
    // A mirrored node turns triangles inside out unless they run the other way.
    add_triangles(order, mode, glm::determinant(glm::dmat3(world)) < 0.0);
  }

  void add_triangles(const std::vector<std::uint32_t>& order, int mode, bool mirrored) {
    auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      for (const std::uint32_t v : mirrored ? std::array{a, c, b} : std::array{a, b, c})
        soup_.corner_vertex.push_back(v);
      soup_.face_end.push_back(static_cast<std::uint32_t>(soup_.corner_vertex.size()));
    };
    if (mode == TINYGLTF_MODE_TRIANGLES && order.size() % 3 != 0)
      stop(fmt::format("{} corners do not make whole triangles", order.size()));
    if ((soup_.corner_vertex.size() + 3 * order.size()) >= 0xFFFFFF00u)
      throw InputError(shown(file_), "too many triangles", remedy_too_many);
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      for (std::size_t i = 0; i + 2 < order.size(); i += 3) add(order[i], order[i + 1], order[i + 2]);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      for (std::size_t i = 0; i + 2 < order.size(); ++i)
        add(order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]);
    } else {
      for (std::size_t i = 1; i + 1 < order.size(); ++i) add(order[i], order[i + 1], order[0]);
    }
  }

  void take_attributes(const tinygltf::Primitive& primitive, std::size_t count) {
    const std::size_t total = soup_.positions.size();
    soup_.vertex_uv.resize(total, glm::vec2(0.0F));
    soup_.vertex_color.resize(total, glm::vec4(1.0F));
    if (const auto found = primitive.attributes.find("TEXCOORD_0"); found != primitive.attributes.end()) {
      const GltfNumbers uv = numbers(found->second);
      if (uv.components != 2 || uv.count != count) stop("texture coordinates are not one pair a vertex");
      for (std::size_t v = 0; v < count;
           ++v)  // glTF counts v from the top of the picture, all others from the bottom
        soup_.vertex_uv[total - count + v] = glm::vec2(uv.at(v, 0), 1.0 - uv.at(v, 1));
      any_uv_ = true;
    }
    if (const auto found = primitive.attributes.find("COLOR_0"); found != primitive.attributes.end()) {
      const GltfNumbers color = numbers(found->second);
      if (color.components < 3 || color.count != count) stop("colours are not one RGB or RGBA a vertex");
      for (std::size_t v = 0; v < count; ++v)
        soup_.vertex_color[total - count + v] = glm::vec4(color.at(v, 0), color.at(v, 1), color.at(v, 2),
                                                          color.components == 4 ? color.at(v, 3) : 1.0);
      any_color_ = true;
    }
  }

  const tinygltf::Model& model_;
  std::size_t most_, used_ = 0;
  const std::filesystem::path& file_;
  PolygonSoup soup_;
  bool any_uv_ = false, any_color_ = false;
};

}  // namespace

Mesh read_gltf(FileBytes bytes, const std::filesystem::path& file, ReadReport& report) {
  report.format = bytes.view().starts_with("glTF") ? "glTF (binary)" : "glTF";
  const GltfGeometry geometry = check_gltf(bytes.view(), file);
  const std::unique_ptr<tinygltf::Model> model = load_model(geometry, file);
  return to_mesh(SceneReader(*model, geometry.bytes, file).read(), file, report);
}

}  // namespace verdigris::io
