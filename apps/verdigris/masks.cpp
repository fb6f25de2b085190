#include "masks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "start.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/mesh_values.hpp"
#include "verdigris/exposure/surface_field.hpp"
#include "verdigris/io/read_points.hpp"
#include "verdigris/surface/ghost_values.hpp"
#include "verdigris/synthesis/builtin.hpp"

using namespace verdigris;

namespace {

constexpr const char* barring = "barrier";

std::unique_ptr<ScalarField> source_of(const MaskPlan& mask) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  try {
    return catalogue.find(mask.source).create(mask.parameters, mask.seed);
  } catch (const InputError& error) {
    throw InputError(fmt::format("masks.{}: {}", mask.name, error.where()), error.problem(), error.remedy());
  }
}

Field<float> values_of(const Surface& surface, const MaskPlan& mask, const ReadReport& read) {
  if (mask.source.empty()) {
    Field<float> values = file_values(surface, read_numbers(mask.file), read.file_vertices, read.file_faces,
                                      mask.on, mask.file.string());
    copy_to_ghosts(surface, values);
    stretch_to_unit(values, mask.low.value_or(0.0), mask.high.value_or(1.0));
    return values;
  }
  const auto field = source_of(mask);
  const ValueRange range = field->range();
  const double low = mask.low.value_or(static_cast<double>(range.least)),
               high = mask.high.value_or(static_cast<double>(range.greatest));
  if (low == high)
    throw InputError("masks." + mask.name, fmt::format("low and high are both {}", low),
                     "leave some range between them");
  Field<float> values = field_on_surface(surface, *field, {mask.scale});
  stretch_to_unit(values, low, high);
  return values;
}

}  // namespace

void check_masks(const Scene& scene, const BehaviourEntry& behaviour) {
  for (const MaskPlan& mask : scene.masks) {
    const auto& taken = behaviour.masks;
    if (mask.name != barring && std::find(taken.begin(), taken.end(), mask.name) == taken.end())
      throw InputError("masks." + mask.name, fmt::format("{} takes no mask of that name", behaviour.name),
                       taken.empty() ? fmt::format("it takes only {}", barring)
                                     : fmt::format("it takes {} and {}", fmt::join(taken, ", "), barring));
    if (mask.name == barring && !scene.barrier.mask.empty())
      throw InputError("masks.barrier", "barrier.mask is given too", "keep one of them");
    if (mask.source.empty() && mask.low.value_or(0.0) == mask.high.value_or(1.0))
      throw InputError("masks." + mask.name, "low and high are the same", "leave some range between them");
    if (!mask.source.empty()) source_of(mask);
  }
}

std::vector<Mask> make_masks(const Surface& surface, const Scene& scene, const ReadReport& read) {
  std::vector<Mask> masks;
  for (const MaskPlan& mask : scene.masks) masks.push_back({mask.name, values_of(surface, mask, read)});
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
