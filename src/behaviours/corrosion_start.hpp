#pragma once
// What a run of corrosion starts from.

#include <cstdint>

#include "verdigris/behaviours/corrosion_growth.hpp"

namespace verdigris::corrosion {

/// Throws InputError as the constructor of CorrosionGrowth says.
void check(const SimulationSetup& setup, const CorrosionParameters& parameters);

/// Mask `name` in 256 levels, 255 for 1, ghosts like their owners; empty when there is none. Throws
/// InputError when it has not a number for each slot.
Field<std::uint8_t> levels_of(const SimulationSetup& setup, const char* name);

/// Strong cells, barrier and given seeds; every sound cell knows whether it holds.
Field<CorrosionRule::State> first_state(const SimulationSetup& setup, const CorrosionParameters& parameters,
                                        const CorrosionRule& rule);

}  // namespace verdigris::corrosion
