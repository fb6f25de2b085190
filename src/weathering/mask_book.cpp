#include "verdigris/weathering/mask_book.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "verdigris/exposure/mask_expression.hpp"

namespace verdigris {

namespace {

constexpr std::array<const char*, 3> of_state{"bare", "corroded", "damage"};

Field<float> state_mask(const CoatedMetal& metal, std::string_view name) {
  Field<float> values(metal.loss.size(), 0.0f);
  for (std::uint32_t slot = 0; slot < values.size(); ++slot)
    values[slot] = name == "bare"       ? static_cast<float>(cover(metal, slot) < bare_below)
                   : name == "corroded" ? static_cast<float>(metal.corroded[slot] >= 0.0f)
                                        : metal.damage[slot];
  return values;
}

}  // namespace

std::vector<std::string> mask_book_names(const std::vector<std::string>& own, const MaskCatalogue& sources) {
  std::vector<std::string> names = formula_names(own, sources);
  for (const char* name : of_state)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
  return names;
}

MaskBook::MaskBook(SourceMasks& sources, std::vector<Mask> own) : sources_(sources), own_(std::move(own)) {}

Field<float> MaskBook::evaluate(const std::string& expression, const std::string& where,
                                const CoatedMetal& metal) {
  std::vector<std::string> own;
  for (const Mask& mask : own_) own.push_back(mask.name);
  const std::vector<std::string> names = mask_book_names(own, sources_.catalogue());
  const MaskExpression formula(expression, names, where);
  std::vector<const Field<float>*> fields(names.size(), nullptr);
  std::vector<Field<float>> now;
  now.reserve(of_state.size());
  for (const std::uint32_t k : formula.used()) {
    if (k < own_.size()) {
      fields[k] = &own_[k].values;
    } else if (std::find(of_state.begin(), of_state.end(), names[k]) != of_state.end()) {
      now.push_back(state_mask(metal, names[k]));
      fields[k] = &now.back();
    } else {
      fields[k] = &sources_.named(names[k]);
    }
  }
  return formula.evaluate(fields, sources_.surface().slot_count());
}

}  // namespace verdigris
