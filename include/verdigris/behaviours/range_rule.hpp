#pragma once
// Larger-than-Life rules: two states, birth and survival by the number of live cells within some cells'
// reach. Evans 2001, "Larger than Life: Digital Creatures in a Family of Two-Dimensional Cellular Automata".

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace verdigris {

/// Which cells within the range are counted.
enum class RangeShape : std::uint8_t {
  moore,        ///< the square: |dx|, |dy| <= range
  von_neumann,  ///< the diamond: |dx| + |dy| <= range
  circular,     ///< the disc: dx^2 + dy^2 <= range^2 + range
};

/// A rule of any range. [count] of `birth` and `survival` says what that many live cells do.
struct RangeRule {
  static constexpr unsigned most_range = 10;

  unsigned range = 1;   ///< cells, 1 to most_range
  bool middle = false;  ///< the cell itself is counted too
  RangeShape shape = RangeShape::moore;
  std::vector<std::uint8_t> birth, survival;  ///< [0 .. cells_counted()]

  /// Half the width of the neighbourhood in the row dy away: |dx| <= half_width(dy).
  int half_width(int dy) const;
  /// Cells that are counted.
  unsigned cells_counted() const;

  friend bool operator==(const RangeRule&, const RangeRule&) = default;
};

/// Reads the notation of Golly and MCell: "R5,C0,M1,S34..58,B34..45,NM" or with sets, "R2,C2,S6-9,B7,8,NN":
/// range, states (0 or 2), whether the middle counts, survival, birth, neighbourhood (M, N or C). Any case; M
/// and N may be left out. Throws InputError for anything else, more than two states included.
RangeRule parse_range_rule(std::string_view text);

/// The rule in that notation; parse_range_rule gives the same rule back.
std::string range_rule_text(const RangeRule& rule);

}  // namespace verdigris
