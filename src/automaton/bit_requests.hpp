#pragma once
// What the patches of a packed surface ask of each other for their ghosts, until each knows what to send.

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace verdigris {

/// Requests in the order in which patches make them: each names bits of one other patch, which are to stand
/// side by side in the stream.
class BitRequests {
 public:
  /// Where the bits of a request are needed: left or right of a group of words, or by a loose run.
  enum class Use : std::uint32_t { left, right, loose };
  struct Request {
    std::uint32_t sender, first;  // its bits are from `first` on, up to those of the next request
    Use use;
    std::uint32_t index;  // of the group or loose run
  };

  void begin(std::uint32_t sender, Use use, std::size_t index) {
    requests_.push_back(
        {sender, static_cast<std::uint32_t>(bits_.size()), use, static_cast<std::uint32_t>(index)});
  }
  /// One more bit of the request begun last, by its number within the sender.
  void add(std::uint32_t bit) { bits_.push_back(bit); }
  std::size_t bit_count() const { return bits_.size(); }

  /// Calls visit(request, its bits) for those that each of `patches` is asked for, patch by patch, and
  /// done(patch) after each patch's.
  template <typename Visit, typename Done>
  void by_sender(std::size_t patches, Visit&& visit, Done&& done) const {
    std::vector<std::uint32_t> begin(patches + 1, 0), order(requests_.size());
    for (const Request& request : requests_) ++begin[request.sender + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (std::uint32_t k = 0; k < requests_.size(); ++k) order[begin[requests_[k].sender]++] = k;
    auto next = order.begin();
    for (std::uint32_t patch = 0; patch < patches; ++patch) {
      for (; next != order.end() && requests_[*next].sender == patch; ++next) {
        const std::size_t from = requests_[*next].first,
                          to = *next + 1 < requests_.size() ? requests_[*next + 1].first : bits_.size();
        visit(requests_[*next], std::span<const std::uint32_t>(bits_.data() + from, bits_.data() + to));
      }
      done(patch);
    }
  }

 private:
  std::vector<Request> requests_;
  std::vector<std::uint32_t> bits_;
};

}  // namespace verdigris
