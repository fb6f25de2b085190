#pragma once
// The open catalogue of primitives: scalar fields by name, each with parameters that describe themselves.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "verdigris/base/parameters.hpp"
#include "verdigris/synthesis/scalar_field.hpp"

namespace verdigris {

/// One primitive of the catalogue.
struct PrimitiveEntry {
  std::string name;
  std::string summary;  ///< one line
  int dimension = 3;    ///< how many coordinates it reads, 1 to 4; the others change nothing
  std::vector<ParameterInfo> parameters;
  /// Throws InputError for parameters it does not have or cannot use.
  std::function<std::unique_ptr<ScalarField>(const ParameterValues&, std::uint64_t seed)> create;
};

/// Primitives by name. A value: whoever makes one may add to it, from outside the library too.
class PrimitiveCatalogue {
 public:
  /// Throws std::invalid_argument when the name is taken.
  void add(PrimitiveEntry entry);

  /// Throws InputError naming the primitives there are.
  const PrimitiveEntry& find(std::string_view name) const;
  const std::vector<PrimitiveEntry>& entries() const { return entries_; }

 private:
  std::vector<PrimitiveEntry> entries_;
};

/// The entry of a self-describing primitive: a struct P with `static constexpr const char *name, *summary`,
/// `static constexpr int dimension`, `template <typename V> void parameters(V&&)` (see describe_parameters)
/// and `std::unique_ptr<ScalarField> make(std::uint64_t seed) const`.
template <typename P>
PrimitiveEntry primitive_entry() {
  return {P::name, P::summary, P::dimension, describe_parameters<P>(),
          [](const ParameterValues& values, std::uint64_t seed) {
            return with_parameters<P>(P::name, values).make(seed);
          }};
}

}  // namespace verdigris
