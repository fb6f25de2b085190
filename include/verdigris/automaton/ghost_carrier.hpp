#pragma once
// How a state comes from its owner to its ghosts.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/automaton/link_turns.hpp"
#include "verdigris/base/prefetch.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Shows each ghost its owner's state: as it is, or turned for a TurningBehaviour, which costs a byte a
/// ghost. Nothing to carry when links are projected. The surface must outlive it.
template <Behaviour B>
class GhostCarrier {
 public:
  using State = typename B::State;

  explicit GhostCarrier(const Surface& surface) : surface_(surface) {
    if constexpr (TurningBehaviour<B>)
      if (surface.link_kind() == LinkKind::unfolded) turns_ = link_turns(surface);
  }

  /// Calls store(ghost, state it shows) for `ghosts`, the targets of a source in `state`.
  template <typename Store>
  [[gnu::always_inline]] void carry(const B& behaviour, std::span<const std::uint32_t> ghosts, State state,
                                    Store&& store) const {
    if constexpr (TurningBehaviour<B>) {
      const auto first = static_cast<std::size_t>(ghosts.data() - surface_.links().all_targets().data());
      for (std::size_t k = 0; k < ghosts.size(); ++k) store(ghosts[k], shown(behaviour, state, first + k));
    } else {
      for (const std::uint32_t ghost : ghosts) store(ghost, state);
    }
  }

  /// All ghosts. For once: steppers that do it every step know the `sources` of all targets.
  void refresh(const B& behaviour, Field<State>& state) const {
    if (surface_.link_kind() != LinkKind::unfolded) return;
    const Links& links = surface_.links();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, links.word_count(), 1024),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        links.for_each_between(
                            range.begin(), range.end(), [&](std::uint32_t source, auto ghosts) {
                              carry(behaviour, ghosts, state[source],
                                    [&](std::uint32_t ghost, State shown) { state[ghost] = shown; });
                            });
                      });
  }

  /// The same faster, `sources` as of Links::sources_of_targets().
  void refresh(const B& behaviour, Field<State>& state, std::span<const std::uint32_t> sources) const {
    if (surface_.link_kind() != LinkKind::unfolded) return;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, sources.size(), 16384),
        [&](const tbb::blocked_range<std::size_t>& range) {
          // Found once: what is written may look like pointers to a compiler.
          State* const cells = state.data();
          const std::uint32_t *const from = sources.data(), *const to = surface_.links().all_targets().data();
          const std::size_t last = range.end() - 1;
          for (std::size_t k = range.begin(); k <= last; ++k) {
            prefetch_for_writing(cells + to[std::min(k + ahead, last)]);
            cells[to[k]] = shown(behaviour, cells[from[k]], k);
          }
        });
  }

  std::size_t bytes() const { return turns_.size(); }

 private:
  static constexpr std::size_t ahead = 32;  // ghosts fetched before their turn

  // What target `k` shows of its source.
  [[gnu::always_inline]] State shown(const B& behaviour, State state, [[maybe_unused]] std::size_t k) const {
    if constexpr (TurningBehaviour<B>)
      return behaviour.turned(state, turns_[k]);
    else
      return state;
  }

  const Surface& surface_;
  std::vector<std::uint8_t> turns_;  // [index into all_targets()]
};

}  // namespace verdigris
