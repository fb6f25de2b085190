#pragma once
// What happens to a surface, one operation after the other.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verdigris/weathering/mask_book.hpp"
#include "verdigris/weathering/operators.hpp"

namespace verdigris {

/// One operation: an operator, and values for its parameters and masks. A mask is given as a text, an
/// expression over the names of a MaskBook.
struct TimelineStep {
  std::string op;
  ParameterValues values;
  std::string where;  ///< for messages: "scene.toml:12"; empty: the operator's name
};

/// What an operation did, and how the surface stands after it.
struct TimelineRecord {
  std::string op;
  double years = 0.0;  ///< since the beginning, as operators report them
  OperatorReport report;
  CoatedNumbers numbers;
  double seconds = 0.0;
};

/// Who wants to hear of a timeline. All may be empty.
struct TimelineListener {
  /// Share of operation `step` (from 0) done; false: stop.
  std::function<bool(std::size_t step, double share)> progress = {};
  /// After each operation.
  std::function<void(std::size_t step, const CoatedMetal&, const TimelineRecord&)> after = {};
  /// Places in the timeline, ascending, that `at` wants to see: 2.25 is a quarter of the years into operation
  /// 2, when operations 0 and 1 are done. Only operators that take time are seen between whole numbers;
  /// ghosts of what is seen there mean nothing.
  std::vector<double> moments = {};
  std::function<void(std::size_t moment, const CoatedMetal&)> at = {};
};

/// [step] the years that each operation takes. Throws as check_timeline does.
std::vector<double> timeline_years(const OperatorCatalogue& operators, std::span<const TimelineStep> steps);

/// Refuses what can be known before there is a surface: operators, parameters and masks there are not, and
/// expressions that do not read. Throws InputError saying where.
void check_timeline(const OperatorCatalogue& operators, std::span<const TimelineStep> steps,
                    std::span<const std::string> mask_names);

/// Runs the operations in order, each with random numbers of its own made from `seed` and its place. Stops
/// after an operation that was told to. Returns a record for each that was made. Throws InputError saying
/// where.
std::vector<TimelineRecord> run_timeline(const OperatorCatalogue& operators, const Surface& surface,
                                         CoatedMetal& metal, std::span<const TimelineStep> steps,
                                         MaskBook& masks, std::uint64_t seed,
                                         const TimelineListener& listener = {});

}  // namespace verdigris
