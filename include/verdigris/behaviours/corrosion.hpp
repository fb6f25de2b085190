#pragma once
// Corrosion as a strategy of attack and defence between cells (Gobron & Chiba 1999, "Corrosion and Patina
// Generation", Fig. 19 and Appendix 1).

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/behaviours/corrosion_forces.hpp"

namespace verdigris {

/// The rule. Each corroded cell picks some of its sound neighbours and attacks them in the next step; a sound
/// cell that is attacked with a force above its defence becomes corroded.
///
/// *How many* (f1): age a attacks 1 + (v - 1) min(a, reach_age) / reach_age neighbours, rounded down, v the
/// number of sound ones but at most seven. *Which*: drawn from the eight directions without repetition, a
/// side twice as likely as a corner (the 3x3 Gaussian); what is not sound there is attacked in vain. Drawn
/// from the sound ones only, nearly all would be attacked, and spots were rounded squares. *Force*: attack
/// min(a, attack_age) / attack_age, the share `luck` of it times a random number of (0, 1]. *Defence* (f2):
/// the cell's own, weak or strong, and `support` for each neighbour that is strong and sound. A cell whose
/// defence no force can exceed *holds* until a helper falls.
///
/// State: one word. Bits 0..7: the neighbours it will attack, counter-clockwise from the right; 8: strong; 9:
/// a sound cell holds, a corroded one is spent (no sound neighbour, or no metal to overcome one, is left);
/// 10: corroded and idle, as all its sound neighbours hold; from 11: step in which it corroded, plus one.
///
/// Across edges neighbours need not see each other: the grids are turned. So that no cell stays out of reach
/// for ever, one that is idle or spent for want of neighbours attacks all around, as long as it has metal.
struct CorrosionRule {
  using State = std::uint32_t;
  static constexpr State strong_bit = 1u << 8, done_bit = 1u << 9, idle_bit = 1u << 10;
  static constexpr unsigned birth_shift = 11;
  static constexpr State absent = ~State{0} << birth_shift;  ///< a barrier, or beyond a boundary
  static constexpr std::uint64_t last_step = (absent >> birth_shift) - 2;
  static constexpr std::uint32_t direction_purpose = 0x434f5201, force_purpose = 0x434f5202;

  std::span<const std::uint8_t> exposure =
      {};                                   ///< [slot] share of the attack that arrives, 255: all; or empty
  std::span<const std::uint8_t> rate = {};  ///< [slot] speed of the loss of metal, 255: all; or empty
  std::array<std::uint64_t, 256> lifetime;  ///< [rate] age in steps at which no metal is left
  std::uint64_t now = 0;                    ///< the step being made

  explicit CorrosionRule(const CorrosionForces& f = {})
      : forces_(f),
        ripe_(f.ripe_age()),
        can_hold_(std::max(f.defence, f.strong_defence) + 8.0 * f.support >= f.attack) {
    lifetime.fill(~std::uint64_t{0});
  }
  const CorrosionForces& forces() const { return forces_; }

  static bool sound(State s) { return s >> birth_shift == 0; }
  static bool corroded(State s) { return !sound(s) && s < absent; }
  static bool strong(State s) { return s < absent && (s & strong_bit) != 0; }
  static State sound_word(bool strong) { return strong ? strong_bit : 0; }
  static State corroded_word(std::uint64_t step, State before) {
    return static_cast<State>(step + 1) << birth_shift | (before & strong_bit);
  }
  static std::uint64_t birth(State s) { return (s >> birth_shift) - std::uint64_t{1}; }

  State outside() const { return absent; }
  bool settled(State s) const { return s >= absent || (corroded(s) && (s & done_bit) != 0); }
  State turned(State s, unsigned eighths) const {
    return (s & ~State{0xFF}) | std::rotl(static_cast<std::uint8_t>(s), static_cast<int>(eighths));
  }
  bool wakes(State before, State after) const {
    return sound(before) || (before & ~after & idle_bit) != 0 ||
           ((before & 0xFFu) == 0 && (after & 0xFFu) != 0);
  }
  bool quiet(const Neighbourhood<State>& n) const {
    bool any = corroded(*n.here);
    for (const State s : around(n)) any = any || corroded(s);
    return !any;
  }
  bool waits(const Neighbourhood<State>& n) const { return still_waits(n, *n.here); }
  bool still_waits(const Neighbourhood<State>& n, State here) const {
    if (!sound(here)) return here < absent && (here & (done_bit | idle_bit)) == 0 && (here & 0xFFu) != 0;
    if ((here & done_bit) != 0) return false;
    State any = 0;
    for (const State s : around(n)) any |= s;
    return (any & 0xFFu) != 0;
  }
  /// A cell too young to overcome anyone sleeps until it is not.
  std::uint64_t alarm(State s) const {
    const bool young = corroded(s) && (s & (done_bit | idle_bit | 0xFFu)) == 0;
    return young && ripe_ <= forces_.attack_age ? birth(s) + ripe_ - 1 : 0;
  }

  void begin_step(std::uint64_t step) { now = step; }

  [[gnu::always_inline]] State next(const Neighbourhood<State>& n, const CellRandom& random) const {
    if (sound(*n.here)) return defend(n, random);
    return settled(*n.here) ? *n.here : strike(n, random);
  }

  /// What a sound cell has against an attack.
  double defence_of(State here, const std::array<State, 8>& near) const {
    int helpers = 0;
    for (const State s : near) helpers += s >> birth_shift == 0 && (s & strong_bit) != 0;
    return ((here & strong_bit) != 0 ? forces_.strong_defence : forces_.defence) + forces_.support * helpers;
  }
  /// The greatest force that can arrive in a cell.
  double greatest_force(std::uint32_t slot) const {
    return exposure.empty() ? forces_.attack : forces_.attack * (exposure[slot] / 255.0);
  }
  /// Age at which a cell has no metal left.
  std::uint64_t lifetime_at(std::uint32_t slot) const { return lifetime[rate.empty() ? 255 : rate[slot]]; }
  /// A sound cell's word with its hold as its neighbours are now.
  State held(State here, const std::array<State, 8>& near, std::uint32_t slot) const {
    return (here & strong_bit) | (defence_of(here, near) >= greatest_force(slot) ? done_bit : 0);
  }
  /// The eight neighbours, counter-clockwise from the right.
  static std::array<State, 8> around(const Neighbourhood<State>& n) {
    return {n.here[1], n.above[1], n.above[0], n.above[-1], n.here[-1], n.below[-1], n.below[0], n.below[1]};
  }
  /// Neighbour k has lain still since it drew its directions, and has no metal left by now.
  bool lies_dead(const Neighbourhood<State>& n, unsigned k, std::uint32_t slot) const {
    const State* const at[8] = {n.here + 1, n.above + 1, n.above, n.above - 1,
                                n.here - 1, n.below - 1, n.below, n.below + 1};
    const State s = *at[k];
    return (s & (done_bit | idle_bit)) != 0 &&
           now - birth(s) > lifetime_at(static_cast<std::uint32_t>(slot + (at[k] - n.here)));
  }
  /// A sound cell may still fall though nothing around it changes.
  bool threatened(const Neighbourhood<State>& n, std::uint32_t slot) const {
    if (!sound(*n.here) || (*n.here & done_bit) != 0) return false;
    const auto near = around(n);
    for (unsigned k = 0; k < 8; ++k)
      if ((near[k] & 0xFFu) != 0 && !lies_dead(n, k, slot)) return true;
    return false;
  }
  /// f1: how many of `valid` sound neighbours a cell of `age` attacks.
  std::uint32_t attacked(std::uint32_t valid, std::uint64_t age) const {
    const auto grown = static_cast<std::uint32_t>(std::min<std::uint64_t>(age, forces_.reach_age));
    return 1u + (std::min(valid, 7u) - 1u) * grown / forces_.reach_age;
  }

 private:
  State defend(const Neighbourhood<State>& n, const CellRandom& random) const;
  State strike(const Neighbourhood<State>& n, const CellRandom& random) const;
  static State draw(std::uint32_t count, const CellRandom& random);

  CorrosionForces forces_;
  std::uint64_t ripe_;
  bool can_hold_;  // some cell may hold against the full force
};

inline CorrosionRule::State CorrosionRule::defend(const Neighbourhood<State>& n,
                                                  const CellRandom& random) const {
  const auto near = around(n);
  const State here = can_hold_ || !exposure.empty() ? held(*n.here, near, random.cell()) : *n.here;
  if ((here & done_bit) != 0) return here;
  std::uint32_t attackers = 0;
  for (unsigned k = 0; k < 8; ++k) attackers |= (near[k] >> ((k + 4) % 8) & 1u) << k;
  if (attackers == 0) return here;
  const double own = defence_of(here, near), force = greatest_force(random.cell());
  const auto words = random.words(force_purpose);
  for (unsigned k = 0; k < 8; ++k) {
    if ((attackers >> k & 1u) == 0) continue;
    if (lies_dead(n, k, random.cell())) continue;
    const std::uint64_t age = now - birth(near[k]);
    const double ripe =
        static_cast<double>(std::min<std::uint64_t>(age, forces_.attack_age)) / forces_.attack_age;
    const double u = ((words[k / 2] >> (k % 2 * 16) & 0xFFFFu) + 1.0) / 65536.0;
    if (force * ripe * (1.0 - forces_.luck * (1.0 - u)) > own) return corroded_word(now, here);
  }
  return here;
}

inline CorrosionRule::State CorrosionRule::strike(const Neighbourhood<State>& n,
                                                  const CellRandom& random) const {
  State valid = 0, open = 0;
  const auto near = around(n);
  for (unsigned k = 0; k < 8; ++k) {
    const State is_sound = near[k] >> birth_shift == 0;
    valid |= is_sound << k;
    open |= (is_sound & ~(near[k] / done_bit)) << k;
  }
  const State here = *n.here & ~(State{0xFF} | idle_bit);
  const std::uint64_t age = now - birth(here);
  const std::uint64_t lifetime = lifetime_at(random.cell());
  const bool gone = age >= lifetime;
  if (valid == 0) return here | done_bit | (gone ? 0 : 0xFFu);
  if (open == 0) return here | idle_bit | (valid == 0xFFu ? 0x7Fu : 0xFFu);
  // Spent, too, is one that will have no metal left when it could overcome someone.
  if (gone || lifetime < ripe_) return here | done_bit;
  // It attacks in the next step, a step older.
  if (age + 1 < ripe_) return here;
  return here | draw(attacked(static_cast<std::uint32_t>(std::popcount(valid)), age + 1), random);
}

/// `count` of the eight directions: weighted sampling without replacement takes the greatest of u^(1/w)
/// (Efraimidis & Spirakis 2006); with weights 2 and 1, u^(1/2) and u, that is u and u^2.
inline CorrosionRule::State CorrosionRule::draw(std::uint32_t count, const CellRandom& random) {
  const auto words = random.words(direction_purpose);
  std::array<std::uint32_t, 8> key;
  for (unsigned k = 0; k < 8; ++k) {
    const std::uint32_t u = (words[k / 2] >> (k % 2 * 16) & 0xFFFFu) + 1u;
    // With the direction in the last bits no two are equal, and no branch is needed to find it.
    key[k] = ((k % 2 == 0 ? u * 0xFFFFu : u * u - (u >> 16)) & ~7u) | k;
  }
  State chosen = 0;
  for (; count > 0; --count) {
    std::uint32_t greatest = 0;
    for (const std::uint32_t other : key) greatest = std::max(greatest, other);
    chosen |= State{1} << (greatest & 7u);
    for (std::uint32_t& other : key) other = other == greatest ? 0 : other;
  }
  return chosen;
}

}  // namespace verdigris
