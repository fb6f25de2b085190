#include "verdigris/io/read_material.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "embedded_materials.hpp"
#include "file_bytes.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/base/hex_colour.hpp"

namespace verdigris {

namespace {

constexpr double most_um = 1e9, most_years = 1e9;

// A table of the file; every key is asked for once, and what was not asked for is an error.
class Table {
 public:
  Table(const std::string& where, const toml::table& table, std::string name)
      : where_(where), table_(table), name_(std::move(name)) {}

  [[noreturn]] void fail(const toml::node& node, const std::string& what, const std::string& remedy) const {
    throw InputError(fmt::format("{}:{}", where_, node.source().begin.line), what, remedy);
  }
  [[noreturn]] void missing(const char* key, const std::string& remedy) const {
    fail(table_, fmt::format("{} has no '{}'", name_, key), remedy);
  }
  void only(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, node] : table_)
      if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
        fail(node, fmt::format("{} has no key '{}'", name_, key.str()),
             fmt::format("the keys are: {}", fmt::join(keys, ", ")));
  }
  const toml::node* find(const char* key) const { return table_.get(key); }

  std::string text(const char* key) const {
    const toml::node* node = find(key);
    if (node == nullptr) missing(key, "write one, in quotes");
    if (!node->is_string()) fail(*node, fmt::format("{}.{} is not a string", name_, key), "put it in quotes");
    return node->as_string()->get();
  }
  double number_of(const toml::node& node, const char* key, double least, double greatest) const {
    const auto value = node.is_number() ? node.value<double>() : std::optional<double>();
    if (!value || !(*value >= least && *value <= greatest))
      fail(node, fmt::format("{}.{} is not a number from {} to {}", name_, key, least, greatest),
           "correct the value");
    return *value;
  }
  double number(const char* key, double least, double greatest, std::optional<double> otherwise = {}) const {
    if (const toml::node* node = find(key)) return number_of(*node, key, least, greatest);
    if (!otherwise) missing(key, fmt::format("write a number from {} to {}", least, greatest));
    return *otherwise;
  }
  bool flag(const char* key) const {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    if (!node->is_boolean())
      fail(*node, fmt::format("{}.{} is not true or false", name_, key), "write true or false");
    return node->as_boolean()->get();
  }
  // One number for all exposure classes, or six.
  PerClass per_class(const char* key, double greatest, std::optional<double> otherwise = {}) const {
    const toml::node* node = find(key);
    PerClass values{};
    if (node == nullptr || !node->is_array()) {
      values.fill(number(key, 0.0, greatest, otherwise));
      return values;
    }
    const toml::array& array = *node->as_array();
    if (array.size() != values.size())
      fail(*node, fmt::format("{}.{} has {} numbers", name_, key, array.size()),
           "write one for each class, C1, C2, C3, C4, C5, CX, or one number for all");
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = number_of(*array.get(k), key, 0.0, greatest);
    return values;
  }
  glm::vec3 colour(const char* key) const {
    const toml::node* node = find(key);
    if (node == nullptr) missing(key, "write \"#rrggbb\"");
    const auto colour = hex_colour(node->is_string() ? node->as_string()->get() : std::string());
    if (!colour) fail(*node, fmt::format("{}.{} is not a colour", name_, key), "write \"#rrggbb\"");
    return *colour;
  }
  Table table(const char* key) const {
    const toml::node* node = find(key);
    if (node == nullptr) missing(key, "write it as a table");
    if (!node->is_table())
      fail(*node, fmt::format("{}.{} is not a table", name_, key), "write { key = value, ... }");
    return {where_, *node->as_table(), name_ + "." + key};
  }
  const std::string& where() const { return where_; }
  const std::string& name() const { return name_; }

 private:
  const std::string& where_;
  const toml::table& table_;
  std::string name_;
};

Finish read_finish(const Table& table) {
  Finish finish;
  finish.colour = table.colour("colour");
  finish.roughness = static_cast<float>(table.number("roughness", 0.0, 1.0));
  finish.metallic = static_cast<float>(table.number("metallic", 0.0, 1.0, 0.0));
  finish.specular = static_cast<float>(table.number("specular", 0.0, 1.0));
  finish.shininess = static_cast<float>(table.number("shininess", 0.0, 1e4));
  return finish;
}

GrowthLaw read_law(const Table& table) {
  table.only({"law", "rate", "exponent", "delay", "saturation", "steady_after"});
  GrowthLaw law;
  const std::string kind = table.text("law");
  if (kind == "linear") {
    law.kind = GrowthKind::linear;
  } else if (kind == "parabolic") {
    law.kind = GrowthKind::parabolic;
  } else if (kind == "power") {
    law.kind = GrowthKind::power;
  } else {
    table.fail(*table.find("law"), fmt::format("there is no law '{}'", kind),
               "choose linear, parabolic or power");
  }
  law.rate = table.per_class("rate", most_um);
  if (law.kind == GrowthKind::power) {
    law.exponent = table.number("exponent", 1e-3, 1.0);
    law.steady_after = table.number("steady_after", 1e-3, most_years, most_years);
  } else {
    for (const char* key : {"exponent", "steady_after"})
      if (const toml::node* node = table.find(key))
        table.fail(*node, fmt::format("a {} law has no {}", kind, key),
                   "remove it, or write law = \"power\"");
  }
  law.delay = table.per_class("delay", most_years, 0.0);
  law.saturation = table.per_class("saturation", most_um, most_um);
  return law;
}

Layer read_layer(const Table& table) {
  table.only({"name", "colour", "roughness", "metallic", "specular", "shininess", "opacity", "unit",
              "density", "initial", "shrinks", "growth"});
  Layer layer;
  layer.name = table.text("name");
  layer.finish = read_finish(table);
  layer.opacity = table.number("opacity", 0.0, 0.999);
  layer.unit = table.number("unit", 1e-6, most_um, 1.0);
  layer.density = table.number("density", 1e-3, 100.0);
  layer.initial = table.number("initial", 0.0, most_um, 0.0);
  layer.shrinks = table.flag("shrinks");
  layer.growth = read_law(table.table("growth"));
  return layer;
}

}  // namespace

Material parse_material(std::string_view text, const std::string& where) {
  toml::table root;
  try {
    root = toml::parse(text, where);
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}", where, error.source().begin.line), std::string(error.description()),
                     "correct the TOML at that place");
  }
  const Table top(where, root, "the material");
  top.only({"name", "summary", "metal", "layer"});
  Material material;
  material.name = top.text("name");
  material.summary = top.text("summary");

  const Table metal = top.table("metal");
  metal.only({"colour", "roughness", "metallic", "specular", "shininess", "density", "thickness", "loss"});
  material.metal = read_finish(metal);
  material.density = metal.number("density", 1e-3, 100.0);
  material.thickness = metal.number("thickness", 0.0, most_um);
  material.loss = read_law(metal.table("loss"));

  if (const toml::node* layers = top.find("layer")) {
    if (!layers->is_array_of_tables())
      top.fail(*layers, "'layer' is not a list of tables", "write [[layer]] for each, the lowest first");
    for (const toml::node& node : *layers->as_array())
      material.layers.push_back(
          read_layer(Table(where, *node.as_table(), fmt::format("layer {}", material.layers.size() + 1))));
  }
  if (material.layers.size() > 16)
    top.fail(*top.find("layer"), "more than 16 layers", "leave some out, or join them");
  return material;
}

Material read_material(const std::filesystem::path& file) {
  io::FileBytes bytes = io::read_file(file);
  io::prepare_text(bytes, file);
  return parse_material(bytes.view(), file.string());
}

namespace {

std::filesystem::path installed_file(const std::string& name) {
  return std::filesystem::path(io::material_directory()) / (name + ".toml");
}

}  // namespace

Material find_material(const std::string& name) {
  if (name.ends_with(".toml")) return read_material(name);
  const std::vector<std::string> names = material_names();
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw InputError(
        "material", fmt::format("there is none named '{}'", name),
        fmt::format("choose one of {}, or give a file that ends in .toml", fmt::join(names, ", ")));
  std::error_code ignored;
  const auto file = installed_file(name);
  if (std::filesystem::is_regular_file(file, ignored)) return read_material(file);
  for (const io::EmbeddedMaterial& material : io::embedded_materials())
    if (material.name == name) return parse_material(material.text, fmt::format("{}.toml (built in)", name));
  throw InputError(file.string(), "it cannot be read", "install it again");
}

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const io::EmbeddedMaterial& material : io::embedded_materials()) names.emplace_back(material.name);
  std::error_code error;
  for (std::filesystem::directory_iterator it(io::material_directory(), error), end; !error && it != end;
       it.increment(error))
    if (it->path().extension() == ".toml") names.push_back(it->path().stem().string());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace verdigris
