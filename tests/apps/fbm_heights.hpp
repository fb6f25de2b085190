#pragma once
// What the library says, for files that run the program: both are called verdigris.

#include <cstdint>
#include <vector>

/// sample_heights of the primitive fbm.
std::vector<float> fbm_heights(double h, std::uint64_t seed, int width, int height, double section);
