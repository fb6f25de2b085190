#pragma once
// Lists of slots that fronts are made of.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace verdigris {

/// A slot and the index of its row.
struct Place {
  std::uint32_t row, slot;
};

/// A list that is written without branches: room is made first, then elements are put and counted or not.
template <typename T>
class SlotList {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  std::size_t bytes() const { return room_.size() * sizeof(T); }
  void clear() { size_ = 0; }
  void reserve_more(std::size_t more) {
    if (room_.size() < size_ + more) room_.resize(std::max(size_ + more, room_.size() + room_.size() / 2));
  }
  /// Needs room for one more, counted or not.
  void put_if(const T& value, bool counts) {
    room_[size_] = value;
    size_ += counts;
  }
  void push(const T& value) {
    reserve_more(1);
    put_if(value, true);
  }
  void append(const SlotList& other) {
    reserve_more(other.size_);
    std::copy_n(other.room_.begin(), other.size_, room_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += other.size_;
  }
  template <typename Keep>
  void keep_if(Keep&& keep) {
    size_ = static_cast<std::size_t>(std::remove_if(room_.begin(),
                                                    room_.begin() + static_cast<std::ptrdiff_t>(size_),
                                                    [&](const T& t) { return !keep(t); }) -
                                     room_.begin());
  }
  const T* begin() const { return room_.data(); }
  const T* end() const { return room_.data() + size_; }

 private:
  std::vector<T> room_;
  std::size_t size_ = 0;
};

}  // namespace verdigris
