#pragma once
// Slots to be looked at in steps to come.

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace verdigris {

/// A list of slots for each coming step that has some. A slot may stand in it more than once.
class Alarms {
 public:
  /// To be taken after `steps` more steps; 0: with the next one.
  void set(std::uint32_t slot, std::uint64_t steps) {
    // Most are for the last step that has a list, or for one behind it.
    lists_.try_emplace(lists_.end(), taken_ + steps)->second.push_back(slot);
  }

  /// Calls visit(slot) for the slots of the next step, which is then past.
  template <typename Visit>
  void take(Visit&& visit) {
    const auto list = lists_.find(taken_++);
    if (list == lists_.end()) return;
    for (const std::uint32_t slot : list->second) visit(slot);
    lists_.erase(list);
  }

  /// Whether `which(slot)` holds for any of them.
  template <typename Which>
  bool any(Which&& which) const {
    for (const auto& [step, list] : lists_)
      for (const std::uint32_t slot : list)
        if (which(slot)) return true;
    return false;
  }

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& [step, list] : lists_) sum += sizeof(list) + list.capacity() * sizeof(list[0]);
    return sum;
  }

 private:
  // By the step, counted from the first one taken.
  std::map<std::uint64_t, std::vector<std::uint32_t>> lists_;
  std::uint64_t taken_ = 0;
};

}  // namespace verdigris
