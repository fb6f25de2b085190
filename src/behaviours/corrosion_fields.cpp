// What a run of corrosion shows of itself: fields of ages and thicknesses.

#include <algorithm>
#include <stdexcept>

#include "verdigris/behaviours/corrosion_growth.hpp"

namespace verdigris {

namespace {

using Word = CorrosionRule::State;

template <typename T, typename Of>
Field<T> each_slot(const Field<Word>& words, Of&& of) {
  Field<T> values(words.size());
  for (std::uint32_t slot = 0; slot < values.size(); ++slot) values[slot] = of(slot, words[slot]);
  return values;
}

}  // namespace

std::vector<FieldInfo> CorrosionGrowth::fields() const {
  return {{"oxide", "um", "thickness of the oxide", FieldKind::quantity, true},
          {"metal", "um", "thickness of the metal that is left", FieldKind::quantity, true},
          {"depth", "um", "thickness of the metal that is lost", FieldKind::quantity, true},
          {"age", "steps", "steps since the cell corroded; -1: sound"},
          {"state", "1", "0 sound, 1 corroded, 2 non-existent: no metal is left"},
          {"strong", "1", "1 strong, 0 weak"},
          {"arrival", "steps", "step in which the cell corroded; -1: never", FieldKind::arrival}};
}

Field<std::int32_t> CorrosionGrowth::ages() const {
  const auto now = static_cast<std::int32_t>(steps());
  return each_slot<std::int32_t>(words(), [&](std::uint32_t, Word word) {
    return CorrosionRule::corroded(word) ? now - static_cast<std::int32_t>(CorrosionRule::birth(word)) : -1;
  });
}

Field<std::int32_t> CorrosionGrowth::field(std::string_view name) const {
  if (name == "age") return ages();
  if (name == "strong")
    return each_slot<std::int32_t>(words(), [](std::uint32_t, Word w) { return CorrosionRule::strong(w); });
  if (name == "arrival")
    return each_slot<std::int32_t>(words(), [](std::uint32_t, Word w) {
      return CorrosionRule::corroded(w) ? static_cast<std::int32_t>(CorrosionRule::birth(w)) : -1;
    });
  if (name == "state")
    return each_slot<std::int32_t>(words(), [&](std::uint32_t slot, Word w) {
      if (!CorrosionRule::corroded(w)) return 0;
      return steps() - CorrosionRule::birth(w) >= rule().lifetime[rate_.empty() ? 255 : rate_[slot]] ? 2 : 1;
    });
  throw std::out_of_range(std::string(name));
}

Field<float> CorrosionGrowth::real_field(std::string_view name) const {
  const LinearThickness& law = parameters_.thickness;
  const auto of_age = [&](double sound, auto&& value) {
    return each_slot<float>(words(), [&](std::uint32_t slot, Word w) {
      if (!CorrosionRule::corroded(w)) return static_cast<float>(w < CorrosionRule::absent ? sound : 0.0);
      const double rate = rate_.empty() ? 1.0 : rate_[slot] / 255.0;
      return static_cast<float>(value(steps() - CorrosionRule::birth(w), rate));
    });
  };
  if (name == "oxide")
    return of_age(0.0, [&](std::uint64_t age, double rate) { return law.oxide(age, rate); });
  if (name == "metal")
    return of_age(law.metal, [&](std::uint64_t age, double rate) { return law.metal_left(age, rate); });
  if (name == "depth")
    return of_age(0.0, [&](std::uint64_t age, double rate) { return law.depth(age, rate); });
  throw std::out_of_range(std::string(name));
}

}  // namespace verdigris
