#pragma once
// Corrosion on its stepper alone, for tests that look at its words.

#include "growth.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"

namespace growth {

using Word = CorrosionRule::State;

/// The attacks that sound cells see, by the owner of the attacker: [slot] how many it attacks.
inline Field<int> attacks_by(const Surface& s, const Field<Word>& words) {
  std::vector<std::uint32_t> owner(s.slot_count());
  for (std::uint32_t slot = 0; slot < owner.size(); ++slot) owner[slot] = slot;
  s.links().for_each([&](std::uint32_t source, auto ghosts) {
    for (const std::uint32_t ghost : ghosts) owner[ghost] = source;
  });
  Field<int> attacks(s.slot_count(), 0);
  for (const Row& row : s.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
      if (!CorrosionRule::sound(words[slot])) continue;
      const Row *below = &row - 1, *above = &row + 1;
      const std::uint32_t x = slot - row.base, b = below->base + x, a = above->base + x;
      const std::uint32_t near[8] = {slot + 1, a + 1, a, a - 1, slot - 1, b - 1, b, b + 1};
      for (unsigned k = 0; k < 8; ++k) attacks[owner[near[k]]] += words[near[k]] >> ((k + 4) % 8) & 1u;
    }
  return attacks;
}

/// All sound, a share strong, some corroded in step 0; each sound cell knows whether it holds.
inline Field<Word> corrosion_start(const Surface& s, const CorrosionRule& rule, double strong,
                                   std::size_t seeds, std::uint64_t seed) {
  Field<Word> state(s.slot_count(), rule.outside());
  each_owned(s, [&](std::uint32_t slot) {
    state[slot] = CorrosionRule::sound_word(CellRandom(seed, 0, slot).words(1)[0] < threshold(strong));
  });
  for (const Seed& at : random_seeds(s, seeds, seed))
    state[at.slot] = CorrosionRule::corroded_word(0, state[at.slot]);
  // A sweep that makes step 0: nothing attacks yet.
  SweepStepper<CorrosionRule> sweep(s, rule, state, seed);
  sweep.step();
  each_owned(s, [&](std::uint32_t slot) {
    if (CorrosionRule::sound(state[slot])) state[slot] = sweep.state()[slot];
  });
  return state;
}

}  // namespace growth
