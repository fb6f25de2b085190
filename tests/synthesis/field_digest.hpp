#pragma once
// A line for each primitive of the catalogue that says which bits it gives.

#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "samples.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {

/// FNV-1a over the bits of the values at 4096 points.
inline std::uint64_t digest(const ScalarField& field, double footprint) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  PointList points = scattered(4000, 1.0);
  for (int k = 0; k < 96; ++k) points.add(k / 8.0, -k / 4.0, k / 2.0, 1000.0 * k);
  for (const float value : values_of(field, points, footprint))
    hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001b3u;
  return hash;
}

/// Every primitive with its defaults and with each choice of its texts, whole numbers and period.
inline std::string field_digests() {
  std::string lines;
  const PrimitiveCatalogue catalogue = builtin_primitives();
  for (const PrimitiveEntry& entry : catalogue.entries()) {
    std::vector<ParameterValues> variants{{}};
    for (const ParameterInfo& p : entry.parameters) {
      for (const std::string& choice : p.choices) variants.push_back({{p.name, choice}});
      if (p.name == "dimensions")
        for (double d = p.least; d <= p.greatest; ++d) variants.push_back({{p.name, d}});
      if (p.name == "period") variants.push_back({{p.name, 1.0}});
    }
    for (const ParameterValues& values : variants)
      for (const double footprint : {0.0, 0.01}) {
        lines += entry.name + " " + (values.empty() ? "" : parameter_text(values[0].second)) + " ";
        try {
          char text[48];
          std::snprintf(text, sizeof text, "%g %016llx\n", footprint,
                        static_cast<unsigned long long>(digest(*entry.create(values, 5), footprint)));
          lines += text;
        } catch (const InputError&) {
          lines += "refused\n";  // not every choice goes with every default
        }
      }
  }
  return lines;
}

}  // namespace verdigris
