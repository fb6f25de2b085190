#include "scene_masks.hpp"

#include <limits>
#include <utility>

#include "scene_table.hpp"
#include "scene_text.hpp"
#include "verdigris/exposure/mask_catalogue.hpp"
#include "verdigris/exposure/mask_expression.hpp"

namespace verdigris::io {

namespace {

constexpr double most = std::numeric_limits<double>::max();

MaskPlan read_mask(const Table& table, const std::filesystem::path& base, std::string name) {
  MaskPlan mask;
  mask.name = std::move(name);
  std::string file, image;
  table.text("source", mask.source);
  table.text("formula", mask.formula);
  table.text("file", file);
  table.text("image", image);
  const int given = !mask.source.empty() + !mask.formula.empty() + !file.empty() + !image.empty();
  if (given != 1)
    table.fail(
        table.raw(), fmt::format("mask {} has {} source", mask.name, given == 0 ? "no" : "more than one"),
        "give one of source = \"fbm\", formula = \"0.5 * ao\", image = \"grey.png\", file = \"numbers.txt\"");
  const auto bound = [&](const char* key, std::optional<double>& to) {
    if (const toml::node* node = table.find(key)) to = table.number_of(*node, key, -most, most);
  };
  bound("low", mask.low);
  bound("high", mask.high);
  if (mask.low && mask.low == mask.high)
    table.fail(table.raw(), fmt::format("low and high of mask {} are the same", mask.name),
               "leave some range between them");
  if (!mask.formula.empty()) {
    table.only({"formula", "low", "high"});
    return mask;
  }
  if (!image.empty()) {
    table.only({"image", "low", "high"});
    mask.image = base / image;
    return mask;
  }
  if (!file.empty()) {
    table.only({"file", "on", "low", "high"});
    mask.file = base / file;
    table.text("on", mask.on);
    if (table.find("on") != nullptr) check_mask_on(mask.on, mask.file.string());
    return mask;
  }
  table.whole("seed", mask.seed, 0, std::numeric_limits<std::int64_t>::max());
  table.number("scale", mask.scale, 1e-9, 1e9);
  for (const auto& [key, node] : table.raw()) {
    const std::string_view name_of_key = key.str();
    if (name_of_key != "source" && name_of_key != "seed" && name_of_key != "scale" && name_of_key != "low" &&
        name_of_key != "high")
      mask.parameters.emplace_back(std::string(name_of_key), table.value_of(node, name_of_key));
  }
  return mask;
}

}  // namespace

std::vector<MaskPlan> read_masks(const std::filesystem::path& file, const toml::table& root) {
  std::vector<MaskPlan> masks;
  const Table all(file, root, "masks");
  if (!all) return masks;
  for (const auto& [key, node] : all.raw()) {
    const std::string name(key.str());
    if (name.empty() ||
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") !=
            std::string::npos)
      all.fail(node, fmt::format("'{}' cannot be the name of a mask", name), "use letters, digits, _ and -");
    masks.push_back(read_mask(Table(file, all.raw(), name, "masks." + name), file.parent_path(), name));
  }
  // Formulas may name one another: they are read when all names are known.
  std::vector<std::string> names;
  for (const MaskPlan& mask : masks) names.push_back(mask.name);
  names = formula_names(std::move(names));
  for (const MaskPlan& mask : masks) {
    if (mask.formula.empty()) continue;
    const toml::node* node = all.raw().get(mask.name)->as_table()->get("formula");
    MaskExpression(mask.formula, names,
                   fmt::format("{}:{}: masks.{}", file.string(), node->source().begin.line, mask.name));
  }
  return masks;
}

std::string mask_text(const MaskPlan& mask, const std::filesystem::path& file) {
  std::string text = fmt::format("\n[masks.{}]\n", mask.name);
  if (!mask.formula.empty()) {
    text += fmt::format("formula = {}\n", quoted(mask.formula));
  } else if (!mask.image.empty()) {
    text += fmt::format("image = {}\n", path_from(file, mask.image));
  } else if (mask.source.empty()) {
    text += fmt::format("file = {}\non = {}\n", path_from(file, mask.file), quoted(mask.on));
  } else {
    text += fmt::format("source = {}\nseed = {}\nscale = {}\n", quoted(mask.source), mask.seed,
                        exact(mask.scale));
    for (const auto& [name, value] : mask.parameters) text += fmt::format("{} = {}\n", name, written(value));
  }
  if (mask.low) text += fmt::format("low = {}\n", exact(*mask.low));
  if (mask.high) text += fmt::format("high = {}\n", exact(*mask.high));
  return text;
}

}  // namespace verdigris::io
