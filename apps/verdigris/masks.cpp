#include "masks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "start.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/mask_expression.hpp"
#include "verdigris/exposure/mesh_values.hpp"
#include "verdigris/exposure/model_colours.hpp"
#include "verdigris/exposure/surface_field.hpp"
#include "verdigris/io/read_image.hpp"
#include "verdigris/io/read_points.hpp"
#include "verdigris/surface/ghost_values.hpp"
#include "verdigris/synthesis/builtin.hpp"

using namespace verdigris;

namespace {

constexpr const char* barring = "barrier";

std::string place_of(const MaskPlan& mask) {
  return "masks." + mask.name;
}

// A source of the library's masks by name; null: a primitive.
const MaskEntry* entry_named(const MaskCatalogue& catalogue, const std::string& name) {
  for (const MaskEntry& entry : catalogue.entries())
    if (entry.name == name) return &entry;
  return nullptr;
}

std::unique_ptr<ScalarField> primitive_of(const MaskPlan& mask) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  const auto& entries = catalogue.entries();
  try {
    return catalogue.find(mask.source).create(mask.parameters, mask.seed);
  } catch (const InputError& error) {
    std::string remedy = error.remedy();
    if (std::none_of(entries.begin(), entries.end(), [&](const auto& e) { return e.name == mask.source; })) {
      const MaskCatalogue others = builtin_masks();
      for (const MaskEntry& entry : others.entries()) remedy += ", " + entry.name;
    }
    throw InputError(fmt::format("{}: {}", place_of(mask), error.where()), error.problem(), remedy);
  }
}

void check_bounds(const MaskPlan& mask, double low, double high) {
  if (mask.low.value_or(low) == mask.high.value_or(high))
    throw InputError(place_of(mask), fmt::format("low and high are both {}", mask.low.value_or(low)),
                     "leave some range between them");
  const auto width = static_cast<float>(mask.high.value_or(high) - mask.low.value_or(low));
  if (width == 0.0f || !std::isfinite(1.0f / width) || !std::isfinite(width))
    throw InputError(place_of(mask), "the range from low to high is none that a float can hold",
                     "give values that are neither so close nor so far apart");
}

// What needs no model.
void check_plan(const MaskPlan& mask) {
  const MaskCatalogue catalogue = builtin_masks();
  if (mask.source.empty()) {
    check_bounds(mask, 0.0, 1.0);
  } else if (const MaskEntry* entry = entry_named(catalogue, mask.source)) {
    check_parameters(fmt::format("{}: {}", place_of(mask), mask.source), entry->parameters, mask.parameters);
    check_bounds(mask, 0.0, 1.0);
    if (mask.scale != 1.0)
      throw InputError(place_of(mask), fmt::format("{} has no scale", mask.source),
                       "leave `scale` out; only primitives such as fbm have one");
  } else {
    const ValueRange range = primitive_of(mask)->range();
    check_bounds(mask, static_cast<double>(range.least), static_cast<double>(range.greatest));
  }
}

ImageValues values_of(const GreyImage& image) {
  ImageValues values{image.width, image.height, {}};
  values.values.reserve(image.levels.size());
  for (const std::uint16_t level : image.levels)
    values.values.push_back(static_cast<float>(level) / 65535.0f);
  return values;
}

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const MaskPlan& mask : scene.masks) names.push_back(mask.name);
  return names;
}

// Makes masks when they are first asked for, for formulas name others; check_masks knows that none leads back
// to itself.
class MaskMaker {
 public:
  MaskMaker(SourceMasks& sources, const Scene& scene, const ReadReport& read)
      : surface_(sources.surface()),
        sources_(sources),
        scene_(scene),
        read_(read),
        names_(formula_names(names_of(scene), sources.catalogue())) {}

  const Field<float>& named(const std::string& name) {
    if (const auto found = made_.find(name); found != made_.end()) return found->second;
    const auto plan = std::find_if(scene_.masks.begin(), scene_.masks.end(),
                                   [&](const MaskPlan& mask) { return mask.name == name; });
    if (plan == scene_.masks.end()) return sources_.named(name);
    return made_.emplace(name, raw(*plan)).first->second;
  }

 private:
  Field<float> raw(const MaskPlan& mask) {
    Field<float> values;
    std::optional<double> low = mask.low, high = mask.high;
    if (!mask.formula.empty()) {
      values = from_formula(mask);
    } else if (!mask.image.empty()) {
      try {
        values = image_mask(surface_, values_of(read_grey_image(mask.image)));
      } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", place_of(mask), error.where()), error.problem(),
                         error.remedy());
      }
    } else if (mask.source.empty()) {
      values = file_values(surface_, read_numbers(mask.file), read_.file_vertices, read_.file_faces, mask.on,
                           mask.file.string());
      copy_to_ghosts(surface_, values);
      if (!low) low = 0.0;
    } else if (const MaskEntry* entry = entry_named(sources_.catalogue(), mask.source)) {
      values = sources_.make(*entry, mask.parameters, mask.seed);
    } else {
      const auto field = primitive_of(mask);
      const ValueRange range = field->range();
      if (!low) low = static_cast<double>(range.least);
      if (!high) high = static_cast<double>(range.greatest);
      values = field_on_surface(surface_, *field, {mask.scale});
    }
    if (low || high) stretch_to_unit(values, low.value_or(0.0), high.value_or(1.0));
    return values;
  }

  Field<float> from_formula(const MaskPlan& mask) {
    const MaskExpression formula(mask.formula, names_, place_of(mask));
    std::vector<const Field<float>*> fields(names_.size(), nullptr);
    for (const std::uint32_t k : formula.used()) fields[k] = &named(names_[k]);
    return formula.evaluate(fields, surface_.slot_count());
  }

  const Surface& surface_;
  SourceMasks& sources_;
  const Scene& scene_;
  const ReadReport& read_;
  std::vector<std::string> names_;            // that formulas may use
  std::map<std::string, Field<float>> made_;  // by name
};

bool taken_by(const BehaviourEntry& behaviour, const std::string& name) {
  return name == barring ||
         std::find(behaviour.masks.begin(), behaviour.masks.end(), name) != behaviour.masks.end();
}

// The masks that are reached from some by formulas.
class Reached {
 public:
  explicit Reached(const Scene& scene) : scene_(scene), names_(formula_names(names_of(scene))) {}

  void visit(const MaskPlan& mask) {
    if (!path_.insert(mask.name).second)
      throw InputError(place_of(mask), "its formula leads back to itself", "name other masks in it");
    if (masks_.insert(mask.name).second && !mask.formula.empty()) {
      const MaskExpression formula(mask.formula, names_, place_of(mask));
      for (const std::uint32_t k : formula.used())
        if (k < scene_.masks.size()) visit(scene_.masks[k]);
    }
    path_.erase(mask.name);
  }
  bool has(const MaskPlan& mask) const { return masks_.count(mask.name) != 0; }

 private:
  const Scene& scene_;
  std::vector<std::string> names_;
  std::set<std::string> masks_, path_;
};

}  // namespace

void check_masks(const Scene& scene) {
  Reached reached(scene);
  for (const MaskPlan& mask : scene.masks) {
    check_plan(mask);
    reached.visit(mask);
  }
}

void check_masks(const Scene& scene, const BehaviourEntry& behaviour) {
  check_masks(scene);
  Reached reached(scene);
  for (const MaskPlan& mask : scene.masks)
    if (taken_by(behaviour, mask.name)) reached.visit(mask);
  for (const MaskPlan& mask : scene.masks) {
    const auto& taken = behaviour.masks;
    if (!reached.has(mask))
      throw InputError(place_of(mask), fmt::format("{} takes no mask of that name", behaviour.name),
                       taken.empty() ? fmt::format("it takes only {}", barring)
                                     : fmt::format("it takes {} and {}", fmt::join(taken, ", "), barring));
    if (mask.name == barring && !scene.barrier.mask.empty())
      throw InputError("masks.barrier", "barrier.mask is given too", "keep one of them");
  }
}

std::vector<Mask> all_masks(SourceMasks& sources, const Scene& scene, const ReadReport& read) {
  MaskMaker maker(sources, scene, read);
  std::vector<Mask> masks;
  for (const MaskPlan& mask : scene.masks) masks.push_back({mask.name, maker.named(mask.name)});
  return masks;
}

std::vector<Mask> make_masks(const Surface& surface, const Scene& scene, const BehaviourEntry& behaviour,
                             const ReadReport& read) {
  SourceMasks sources(surface, scene.picture.up, scene.seed);
  MaskMaker maker(sources, scene, read);
  std::vector<Mask> masks;
  for (const MaskPlan& mask : scene.masks) {
    if (!taken_by(behaviour, mask.name)) continue;
    masks.push_back({mask.name, maker.named(mask.name)});
    for (float& value : masks.back().values) value = std::clamp(value, 0.0f, 1.0f);
  }
  return masks;
}

Field<std::uint8_t> take_barrier(std::vector<Mask>& masks, const Surface& surface, const Scene& scene,
                                 const ReadReport& read) {
  const auto found =
      std::find_if(masks.begin(), masks.end(), [](const Mask& m) { return m.name == barring; });
  if (found == masks.end()) return make_barrier(surface, scene, read);
  Field<std::uint8_t> barrier = barred_by(surface, found->values, scene.barrier.threshold);
  masks.erase(found);
  return barrier;
}
