#include "masks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "start.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"
#include "verdigris/exposure/mask_catalogue.hpp"
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

// Makes masks when they are first asked for, for formulas name others.
class MaskMaker {
 public:
  MaskMaker(const Surface& surface, const Scene& scene, const ReadReport& read)
      : surface_(surface), exposures_(surface), scene_(scene), read_(read), catalogue_(builtin_masks()) {
    for (const MaskPlan& mask : scene.masks) names_.push_back(mask.name);
    for (const MaskEntry& entry : catalogue_.entries())
      if (std::find(names_.begin(), names_.end(), entry.name) == names_.end()) names_.push_back(entry.name);
  }

  const Field<float>& named(const std::string& name) {
    if (const auto found = made_.find(name); found != made_.end()) return found->second;
    const auto plan = std::find_if(scene_.masks.begin(), scene_.masks.end(),
                                   [&](const MaskPlan& mask) { return mask.name == name; });
    Field<float> values =
        plan != scene_.masks.end() ? planned(*plan) : from_catalogue(catalogue_.find(name), {}, scene_.seed);
    return made_.emplace(name, std::move(values)).first->second;
  }

 private:
  Field<float> planned(const MaskPlan& mask) {
    if (!under_way_.insert(mask.name).second)
      throw InputError(place_of(mask), "its formula leads back to itself", "name other masks in it");
    Field<float> values = raw(mask);
    under_way_.erase(mask.name);
    return values;
  }

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
    } else if (const MaskEntry* entry = entry_named(catalogue_, mask.source)) {
      values = from_catalogue(*entry, mask.parameters, mask.seed);
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

  Field<float> from_catalogue(const MaskEntry& entry, const ParameterValues& given, std::uint64_t seed) {
    return entry.create(exposures_, with_up(entry, given, scene_.picture.up), seed);
  }

  Field<float> from_formula(const MaskPlan& mask) {
    const MaskExpression formula(mask.formula, names_, place_of(mask));
    std::vector<const Field<float>*> fields(names_.size(), nullptr);
    for (const std::uint32_t k : formula.used()) fields[k] = &named(names_[k]);
    return formula.evaluate(fields, surface_.slot_count());
  }

  const Surface& surface_;
  ExposureCache exposures_;
  const Scene& scene_;
  const ReadReport& read_;
  MaskCatalogue catalogue_;
  std::vector<std::string> names_;            // that formulas may use: the scene's, then sources
  std::map<std::string, Field<float>> made_;  // by name
  std::set<std::string> under_way_;
};

bool taken_by(const BehaviourEntry& behaviour, const std::string& name) {
  return name == barring ||
         std::find(behaviour.masks.begin(), behaviour.masks.end(), name) != behaviour.masks.end();
}

bool in_a_formula(const Scene& scene, const std::string& name) {
  const MaskCatalogue catalogue = builtin_masks();
  return std::any_of(scene.masks.begin(), scene.masks.end(), [&](const MaskPlan& mask) {
    if (mask.formula.empty()) return false;
    std::vector<std::string> names{name};
    for (const MaskPlan& other : scene.masks) names.push_back(other.name);
    for (const MaskEntry& entry : catalogue.entries()) names.push_back(entry.name);
    const MaskExpression formula(mask.formula, names, place_of(mask));
    return !formula.used().empty() && formula.used().front() == 0;
  });
}

}  // namespace

void check_masks(const Scene& scene, const BehaviourEntry& behaviour) {
  for (const MaskPlan& mask : scene.masks) {
    const auto& taken = behaviour.masks;
    if (!taken_by(behaviour, mask.name) && !in_a_formula(scene, mask.name))
      throw InputError(place_of(mask), fmt::format("{} takes no mask of that name", behaviour.name),
                       taken.empty() ? fmt::format("it takes only {}", barring)
                                     : fmt::format("it takes {} and {}", fmt::join(taken, ", "), barring));
    if (mask.name == barring && !scene.barrier.mask.empty())
      throw InputError("masks.barrier", "barrier.mask is given too", "keep one of them");
    check_plan(mask);
  }
}

std::vector<Mask> all_masks(const Surface& surface, const Scene& scene, const ReadReport& read) {
  for (const MaskPlan& mask : scene.masks) check_plan(mask);
  MaskMaker maker(surface, scene, read);
  std::vector<Mask> masks;
  for (const MaskPlan& mask : scene.masks) masks.push_back({mask.name, maker.named(mask.name)});
  return masks;
}

std::vector<Mask> make_masks(const Surface& surface, const Scene& scene, const ReadReport& read) {
  const Catalogue catalogue = builtin_catalogue();
  const BehaviourEntry& behaviour = catalogue.find(scene.behaviour);
  MaskMaker maker(surface, scene, read);
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
