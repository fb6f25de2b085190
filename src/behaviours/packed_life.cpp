// Bit-sliced counting: the neighbours of 64 cells are added in a few logical operations on whole words.

#include "verdigris/behaviours/packed_life.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>
#include <functional>
#include <utility>

#include "verdigris/base/error.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/base/prefetch.hpp"
#include "word_rows.hpp"

namespace verdigris {

namespace {

// Three cells added up: two binary digits.
struct Sum {
  Rows ones, twos;
};
Sum add(Rows a, Rows b, Rows c) {
  return {parity(a, b, c), majority(a, b, c)};
}
Sum below(const Sum& previous, const Sum& here) {
  return {one_down(previous.ones, here.ones), one_down(previous.twos, here.twos)};
}
Sum above(const Sum& here, const Sum& next) {
  return {one_up(here.ones, next.ones), one_up(here.twos, next.twos)};
}

// A rule as truth table over the sum of a cell and its neighbours, so a live cell's own one is in it. For two
// sums that differ in the last digit alone the next state is (digit & turns) ^ flips; [0] of the dead, [1] of
// the living.
struct Table {
  Rows turns[2][5], flips[2][5];

  explicit Table(const LifeRule& rule) {
    const unsigned alive[2] = {rule.birth, static_cast<unsigned>(rule.survival) << 1};
    for (unsigned was = 0; was < 2; ++was)
      for (unsigned pair = 0; pair < 5; ++pair) {
        const std::uint64_t even = alive[was] >> (2 * pair) & 1, odd = alive[was] >> (2 * pair + 1) & 1;
        turns[was][pair] = Rows{} - (even ^ odd);
        flips[was][pair] = Rows{} - even;
      }
  }
};

// Cells alive next, from the sums of three rows.
[[gnu::always_inline]] inline Rows decide(const Sum& below, const Sum& here, const Sum& above, Rows centre,
                                          const Table& table) {
  const Sum ones = add(below.ones, here.ones, above.ones), twos = add(below.twos, here.twos, above.twos);
  const Rows carry = ones.twos & twos.ones;
  const Rows digit[4] = {ones.ones, ones.twos ^ twos.ones, twos.twos ^ carry, twos.twos & carry};
  Rows next[2];
  for (unsigned was = 0; was < 2; ++was) {
    Rows by_pair[5];
    for (unsigned pair = 0; pair < 5; ++pair)
      by_pair[pair] = (digit[0] & table.turns[was][pair]) ^ table.flips[was][pair];
    const Rows low = choose(digit[1], by_pair[1], by_pair[0]),
               high = choose(digit[1], by_pair[3], by_pair[2]);
    next[was] = choose(digit[3], by_pair[4], choose(digit[2], high, low));
  }
  return choose(centre, next[1], next[0]);
}

std::uint64_t word_at(const unsigned char* bytes) {
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

// Owned bits of a group of words.
Rows owned_bits(const PackedSurface::Group& group) {
  return ones_from(group.owned_begin) & ~ones_from(group.owned_end);
}

// A copy of the state of a patch, its ghosts, of the stream, laid around the owned cells.
void copy_with_ghosts(const PackedSurface& cells, std::size_t patch, const std::uint64_t* state,
                      const unsigned char* stream, std::uint64_t* copy) {
  const PackedSurface::Group* group = cells.groups(patch);
  std::uint64_t* to = copy;
  for (const PackedSurface::Column& column : cells.columns(patch)) {
    const std::uint32_t groups = column.groups();
    for (std::uint32_t g = 0; g < column.inside; ++g) store(to + 8 + 8 * g, load(state + 1 + 8 * g));
    for (std::uint32_t g = column.inside; g < groups; ++g, ++group) {
      const Rows left = turned_left(word_at(stream + group->left_byte), group->left_turn),
                 right = turned_left(word_at(stream + group->right_byte), group->right_turn);
      // Beyond the last word other patches are being written.
      const Rows owned = load_some(state + 1 + 8 * g, column.rows - 1 - 8 * g);
      store(to + 8 + 8 * g,
            owned | (left & ~ones_from(group->owned_begin)) | (right & ones_from(group->owned_end)));
    }
    state += column.rows;
    to += column.pitch();
  }
  for (const PackedSurface::LooseRun& run : cells.loose_runs(patch)) {
    const unsigned char* from = stream + run.bit / 8;
    const unsigned shift = run.bit % 8;
    // Nine bytes hold the next 64 bits.
    const std::uint64_t bits = word_at(from) >> shift | std::uint64_t{from[8]} << 1 << (63 - shift);
    const std::uint64_t mask = run.mask();
    copy[run.at] = (copy[run.at] & ~mask) | (bits << run.begin & mask);
  }
}

// Writes the next state of a patch, from its copy. Returns how many cells changed.
template <LifeNeighbourhood neighbourhood>
std::uint64_t evolve(const PackedSurface& cells, std::size_t patch, const Table& table,
                     const std::uint64_t* copy, std::uint64_t* state) {
  const PackedSurface::Group* group = cells.groups(patch);
  Rows changed{};
  // The patch that comes next is fetched while this one is made; the state of a large one would not stay.
  const std::size_t words = cells.word_begin(patch + 1) - cells.word_begin(patch);
  const std::size_t to_next = patch + 1 < cells.patch_count() && words <= 32768 ? words : 0;
  const std::uint64_t* left_column = copy;  // what stands left of the first is read, but never counts
  for (const PackedSurface::Column& column : cells.columns(patch)) {
    const std::uint64_t* right_column = copy + column.pitch();
    // Vector g of the copy holds words 8 g - 7 to 8 g. Along a row a cell and those beside it are added up.
    const auto along = [&](std::uint32_t g) {
      const Rows centre = load(copy + 8 * g);
      return add(left_of(centre, load(left_column + 8 * g)), centre,
                 right_of(centre, load(right_column + 8 * g)));
    };
    Sum previous = along(0), here = along(1);
    const auto next_rows = [&](std::uint32_t g) {
      prefetch(state + to_next + 8 * g);
      const Sum next = along(g + 2);
      const Rows centre = load(copy + 8 + 8 * g);
      Rows alive;
      if constexpr (neighbourhood == LifeNeighbourhood::moore) {
        alive = decide(below(previous, here), here, above(here, next), centre, table);
      } else {  // rows below and above count the cell alone
        alive = decide({one_down(load(copy + 8 * g), centre), Rows{}}, here,
                       {one_up(centre, load(copy + 16 + 8 * g)), Rows{}}, centre, table);
      }
      previous = here;
      here = next;
      return alive;
    };
    for (std::uint32_t g = 0; g < column.inside; ++g) {
      const Rows next = next_rows(g);
      changed += ones_in(next ^ load(copy + 8 + 8 * g));
      store(state + 1 + 8 * g, next);
    }
    for (std::uint32_t g = column.inside; g < column.groups(); ++g, ++group) {
      const Rows owned = owned_bits(*group), next = next_rows(g) & owned;
      changed += ones_in(next ^ (load(copy + 8 + 8 * g) & owned));
      store_some(state + 1 + 8 * g, next, column.rows - 1 - 8 * g);
    }
    left_column = copy;
    copy = right_column;
    state += column.rows;
  }
  std::uint64_t sum = 0;
  for (unsigned lane = 0; lane < 8; ++lane) sum += changed[lane];
  return sum;
}

}  // namespace

namespace {

std::uint64_t ones_of(std::span<const std::uint64_t> words) {
  std::uint64_t ones = 0;
  for (const std::uint64_t word : words) ones += static_cast<std::uint64_t>(std::popcount(word));
  return ones;
}

}  // namespace

struct PackedLife::Rooms {
  explicit Rooms(std::size_t words) : of_thread([words] { return WordRoom(words); }) {}
  tbb::enumerable_thread_specific<WordRoom> of_thread;
};

PackedLife::PackedLife(const PackedSurface& cells, const LifeRule& rule)
    : cells_(cells),
      rule_(rule),
      state_(large_vector(cells.word_count() + 8, std::uint64_t{0})),
      received_(large_vector(cells.sent().begin(cells.patch_count()) / 64 + 3, std::uint64_t{0})),
      sent_(large_vector(received_.size(), std::uint64_t{0})),
      rooms_(std::make_shared<Rooms>(cells.copy_words())) {}

void PackedLife::set(std::uint32_t bit, bool alive) {
  const std::uint64_t one = std::uint64_t{1} << (bit & 63);
  if (alive)
    state_[bit >> 6] |= one;
  else
    state_[bit >> 6] &= ~one;
  // Written once: others set cells at the same time.
  const std::atomic_ref<bool> up_to_date(up_to_date_);
  if (up_to_date.load(std::memory_order_relaxed)) up_to_date.store(false, std::memory_order_relaxed);
}

void PackedLife::fill(double density, std::uint64_t seed) {
  constexpr std::uint32_t filling = 0x4C494645;
  const std::uint64_t limit = threshold(density);
  tbb::parallel_for(std::size_t{0}, cells_.patch_count(), [&](std::size_t patch) {
    cells_.for_owned_words(patch, [&](std::uint32_t word, std::uint64_t owned) {
      std::uint64_t alive = 0;
      for (std::uint32_t block = 0; block < 16; ++block) {
        const auto words = CellRandom(seed, 0, word).words(filling, block);
        for (unsigned k = 0; k < 4; ++k) alive |= std::uint64_t{words[k] < limit} << (4 * block + k);
      }
      state_[word] = alive & owned;
    });
  });
  up_to_date_ = false;
}

void PackedLife::restore(std::span<const std::uint64_t> state, std::uint64_t steps) {
  // Nothing may live where no cell is owned.
  std::uint64_t alive = 0, owned_alive = 0;
  const bool fits = state.size() == state_.size();
  if (fits) {
    alive = ones_of(state);
    for (std::size_t patch = 0; patch < cells_.patch_count(); ++patch)
      cells_.for_owned_words(patch, [&](std::uint32_t word, std::uint64_t owned) {
        owned_alive += static_cast<std::uint64_t>(std::popcount(state[word] & owned));
      });
  }
  if (!fits || alive != owned_alive)
    throw InputError("cells", "they are not of this surface", "start again without this checkpoint");
  std::copy(state.begin(), state.end(), state_.begin());
  up_to_date_ = false;
  steps_ = steps;
}

std::uint64_t PackedLife::population() const {
  return ones_of(state_);
}

std::uint64_t PackedLife::step() {
  const std::size_t patches = cells_.patch_count();
  // Some 4096 words a task: patches are small by the hundreds of thousands, or huge by the dozen.
  const std::size_t grain =
      std::clamp<std::size_t>(4096 * patches / std::max<std::size_t>(1, cells_.word_count()), 1, 64);
  const tbb::blocked_range<std::size_t> all(0, patches, grain);
  const auto send = [&](std::size_t patch) {
    cells_.sent().gather(patch, state_.data() + cells_.word_begin(patch), sent_.data());
  };
  if (!up_to_date_) {
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t patch = range.begin(); patch < range.end(); ++patch) send(patch);
    });
  }
  std::swap(received_, sent_);
  up_to_date_ = false;  // until all patches have sent
  const Table table(rule_);
  const auto* stream = reinterpret_cast<const unsigned char*>(received_.data());
  const auto advance = [&]<LifeNeighbourhood neighbourhood>(std::size_t patch, std::uint64_t* copy) {
    std::uint64_t* state = state_.data() + cells_.word_begin(patch);
    copy_with_ghosts(cells_, patch, state, stream, copy);
    const std::uint64_t changed = evolve<neighbourhood>(cells_, patch, table, copy, state);
    send(patch);
    return changed;
  };
  const std::uint64_t changed = tbb::parallel_reduce(
      all, std::uint64_t{0},
      [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t sum) {
        std::uint64_t* copy = rooms_->of_thread.local().words();
        for (std::size_t patch = range.begin(); patch < range.end(); ++patch)
          sum += rule_.neighbourhood == LifeNeighbourhood::moore
                     ? advance.operator()<LifeNeighbourhood::moore>(patch, copy)
                     : advance.operator()<LifeNeighbourhood::von_neumann>(patch, copy);
        return sum;
      },
      std::plus<>());
  up_to_date_ = true;
  ++steps_;
  return changed;
}

}  // namespace verdigris
