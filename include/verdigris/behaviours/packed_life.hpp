#pragma once
// Life-like behaviours on packed cells: 64 at a time in a word, eight words at a time in a vector.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "verdigris/automaton/packed_surface.hpp"
#include "verdigris/behaviours/life.hpp"

namespace verdigris {

/// A Life-like rule of range 1 on a surface; the same result as SweepStepper<LifeBehaviour>, for any number
/// of threads and with or without vector instructions. The packed surface must outlive it; the surface need
/// not.
class PackedLife {
 public:
  PackedLife(const PackedSurface& cells, const LifeRule& rule);

  /// One generation. Returns how many cells changed.
  std::uint64_t step();
  std::uint64_t steps() const { return steps_; }
  std::uint64_t population() const;

  bool alive(std::uint32_t bit) const { return (state_[bit >> 6] >> (bit & 63)) & 1u; }
  /// Of an owned cell. Threads may set cells of different words at the same time.
  void set(std::uint32_t bit, bool alive);
  /// Each owned cell alive with probability `density`, from random numbers keyed by seed and word.
  void fill(double density, std::uint64_t seed);

  const std::vector<std::uint64_t>& state() const { return state_; }
  /// Goes on from what state() and steps() were. Throws InputError when it is not of such a surface.
  void restore(std::span<const std::uint64_t> state, std::uint64_t steps);
  /// Bytes of state; the packed surface has its own.
  std::size_t bytes() const { return (state_.size() + received_.size() + sent_.size()) * 8; }

 private:
  const PackedSurface& cells_;
  LifeRule rule_;
  std::vector<std::uint64_t> state_;  // [word], owned bits only
  // [bit / 64] what patches sent each other for the last step, and for the next one.
  std::vector<std::uint64_t> received_, sent_;
  bool up_to_date_ = false;  // sent_ is of state_
  std::uint64_t steps_ = 0;
  struct Rooms;
  std::shared_ptr<Rooms> rooms_;  // for the copy of a patch, one a thread; nothing is in them between steps
};

}  // namespace verdigris
