#include "verdigris/behaviours/corrosion_layers.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace verdigris {

LayerFields corrosion_layers(const CorrosionGrowth& growth, const Material& material, ExposureClass exposure,
                             double step_years) {
  const auto& words = growth.words();
  const auto& rates = growth.rates();
  const std::size_t count = material.layers.size();
  LayerFields fields{std::vector<Field<float>>(count, Field<float>(words.size())),
                     Field<float>(words.size())};
  const auto put = [&](std::size_t slot, const Stack& stack) {
    for (std::size_t k = 0; k < count; ++k) fields.layers[k][slot] = static_cast<float>(stack.layers[k]);
    fields.metal_lost[slot] = static_cast<float>(stack.metal_lost);
  };
  std::vector<Stack> at_age;
  for (std::uint64_t age = 0; age <= growth.steps(); ++age)
    at_age.push_back(stack_at(material, exposure, static_cast<double>(age) * step_years));
  const Stack sound = stack_at(material, exposure, -1.0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, words.size(), 16384),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t slot = range.begin(); slot < range.end(); ++slot) {
                        const CorrosionRule::State word = words[slot];
                        if (CorrosionRule::sound(word)) put(slot, sound);
                        if (!CorrosionRule::corroded(word)) continue;
                        const std::uint64_t age = growth.steps() - CorrosionRule::birth(word);
                        put(slot, rates.empty()
                                      ? at_age[age]
                                      : stack_at(material, exposure, static_cast<double>(age) * step_years,
                                                 rates[slot] / 255.0));
                      }
                    });
  return fields;
}

}  // namespace verdigris
