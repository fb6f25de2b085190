#pragma once
// Slots to be looked at in steps to come.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace verdigris {

/// A list of slots for each of the coming steps. A slot may stand in it more than once.
class Alarms {
 public:
  /// To be taken after `steps` more steps; 0: with the next one.
  void set(std::uint32_t slot, std::uint64_t steps) {
    if (lists_.size() <= steps) lists_.resize(steps + 1);
    lists_[steps].push_back(slot);
  }

  /// Calls visit(slot) for the slots of the next step, which is then past.
  template <typename Visit>
  void take(Visit&& visit) {
    if (lists_.empty()) return;
    for (const std::uint32_t slot : lists_.front()) visit(slot);
    lists_.pop_front();
  }

  /// Whether `which(slot)` holds for any of them.
  template <typename Which>
  bool any(Which&& which) const {
    for (const auto& list : lists_)
      for (const std::uint32_t slot : list)
        if (which(slot)) return true;
    return false;
  }

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& list : lists_) sum += sizeof(list) + list.capacity() * sizeof(list[0]);
    return sum;
  }

 private:
  std::deque<std::vector<std::uint32_t>> lists_;
};

}  // namespace verdigris
