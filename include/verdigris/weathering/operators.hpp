#pragma once
// The open catalogue of operators: what can happen to a coated metal, each with parameters that describe
// themselves.

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/base/parameters.hpp"
#include "verdigris/exposure/exposure_cache.hpp"
#include "verdigris/weathering/coated_metal.hpp"

namespace verdigris {

/// What an operator works with beside its parameters.
struct OperatorSetup {
  const Surface& surface;
  std::uint64_t seed = 1;                           ///< of its random numbers
  std::vector<Mask> masks = {};                     ///< those of OperatorEntry::masks given
  glm::dvec3 up{0.0, 1.0, 0.0};                     ///< away from the ground
  std::function<bool(double share)> progress = {};  ///< false: stop here
  ExposureCache* exposures = nullptr;               ///< what is known of the surface; null: nothing yet
  /// Shares of its years, ascending in 0..1, at which an operator that takes time shows the state reached:
  /// `show` gets the number of the moment and a state whose ghosts mean nothing.
  std::vector<double> moments = {};
  std::function<void(std::size_t moment, const CoatedMetal&)> show = {};

  /// The values of mask `name`; null when there is none.
  const Field<float>* mask(std::string_view name) const;
  /// The same at a cell, clamped to 0..1; 1 when there is none.
  static double at(const Field<float>* mask, std::uint32_t slot);
  /// Tells how far it is; false when it should stop.
  bool go_on(double share) const { return !progress || progress(share); }
};

/// What an operator did.
struct OperatorReport {
  std::uint64_t cells = 0;  ///< owned cells it changed
  /// Micrometres over all owned cells, summed: laid on coats, taken off coats, taken off the metal.
  double added = 0.0, removed = 0.0, metal = 0.0;
  double years = 0.0;                                        ///< that passed
  std::vector<std::pair<std::string, double>> numbers = {};  ///< what it alone can tell
  bool complete = true;                                      ///< false: progress said stop
};

/// One operator of the catalogue.
struct OperatorEntry {
  std::string name, summary;
  std::vector<ParameterInfo> parameters;
  std::vector<std::string> masks;                       ///< names of the masks it takes
  std::function<double(const ParameterValues&)> years;  ///< that it takes; most take none
  std::function<void(const ParameterValues&)> check;    ///< throws InputError for texts that mean nothing
  std::function<OperatorReport(CoatedMetal&, const OperatorSetup&, const ParameterValues&)> apply;
};

/// Operators by name. A value: whoever makes one may add to it, from outside the library too.
class OperatorCatalogue {
 public:
  /// Throws std::invalid_argument when the name is taken, or a mask has the name of a parameter.
  void add(OperatorEntry entry);

  /// Adds a self-describing operator: a type with `static constexpr const char *name, *summary`, `static
  /// std::vector<std::string> masks()`, `template <typename V> void parameters(V&&)` and `OperatorReport
  /// apply(CoatedMetal&, const OperatorSetup&) const`, the same bits for any number of threads. One that
  /// takes time has `double duration() const`, years, and shows its moments; one with texts of its own may
  /// have `void check() const`.
  template <typename O>
  void add() {
    add({O::name, O::summary, describe_parameters<O>(), O::masks(),
         []([[maybe_unused]] const ParameterValues& values) {
           if constexpr (requires(const O& o) { o.duration(); })
             return with_parameters<O>(O::name, values).duration();
           else
             return 0.0;
         },
         []([[maybe_unused]] const ParameterValues& values) {
           if constexpr (requires(const O& o) { o.check(); }) with_parameters<O>(O::name, values).check();
         },
         [](CoatedMetal& metal, const OperatorSetup& setup, const ParameterValues& values) {
           return with_parameters<O>(O::name, values).apply(metal, setup);
         }});
  }

  /// Throws InputError naming the operators there are.
  const OperatorEntry& find(std::string_view name) const;
  const std::vector<OperatorEntry>& entries() const { return entries_; }

 private:
  std::vector<OperatorEntry> entries_;
};

/// The operators of the library: coat, erode, polish, scratch, crack, peel, dust, stain, age.
OperatorCatalogue builtin_operators();

}  // namespace verdigris
