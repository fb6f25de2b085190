#pragma once
// Larger-than-Life on a surface: a byte a cell, counts from running sums along the rows of each patch.

#include <cstdint>
#include <memory>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/behaviours/range_rule.hpp"
#include "verdigris/surface/halo.hpp"

namespace verdigris {

/// A rule of range 1 to 10. Beyond a boundary all is dead. The halo, of the rule's range, must outlive it.
/// The same result for any number of threads.
class LargerThanLife {
 public:
  /// `alive` [slot] 0 or 1; only owned cells count. Throws std::invalid_argument when halo and rule differ in
  /// range.
  LargerThanLife(const Halo& halo, RangeRule rule, Field<std::uint8_t> alive, std::uint64_t steps = 0);

  /// One generation. Returns how many cells changed. Takes range operations a cell, on short numbers.
  std::uint64_t step();
  std::uint64_t steps() const { return steps_; }
  const Field<std::uint8_t>& alive() const { return state_; }
  std::size_t bytes() const { return 2 * state_.size(); }

 private:
  struct Room;
  std::uint64_t advance(std::size_t patch, Room& room);

  const Halo* halo_;
  RangeRule rule_;
  Field<std::uint8_t> state_, next_;
  std::uint64_t steps_ = 0;
  struct Rooms;
  std::shared_ptr<Rooms> rooms_;  // for the raster of a patch, one a thread; nothing is kept between steps
};

}  // namespace verdigris
