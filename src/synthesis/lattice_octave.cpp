#include "lattice_octave.hpp"

#include <fmt/format.h>

#include <cmath>

#include "random_words.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris::synthesis {

namespace {
constexpr std::uint32_t octave_purpose = 0x4f435401;
constexpr double finest = 1e9;  // cells per unit: a double near 1 still has four million steps to a cell
}  // namespace

float LatticeOctave::fade(double footprint) const {
  const double step = frequency * footprint;  // cells from one sample to the next
  if (!(step > 0.25)) return 1.0f;
  if (step >= 0.5) return 0.0f;
  const double t = (0.5 - step) * 4.0;
  return static_cast<float>(t * t * (3.0 - 2.0 * t));
}

LatticeOctave lattice_octave(double frequency, double period, std::uint64_t seed, std::uint32_t index) {
  if (frequency > finest)
    throw InputError("frequency", fmt::format("octave {} has {:.3g} cells per unit", index + 1, frequency),
                     fmt::format("ask for fewer octaves or a lower frequency: {:g} is the most", finest));
  const auto words = random_words(seed, octave_purpose, index, 0);
  const auto shifts = random_words(seed, octave_purpose, index, 1);
  LatticeOctave octave{frequency, words[0], 0, {}};
  double along = frequency;
  if (period > 0.0) {
    along = std::round(frequency * period);
    if (!(along >= 1.0 && along <= 2147483647.0))
      throw InputError("period",
                       fmt::format("a period of {} holds {} cells of octave {}", period, along, index + 1),
                       "it must hold 1 to 2^31: change the period, the frequency or the number of octaves");
    octave.frequency = along / period;
    octave.cells = static_cast<std::uint32_t>(along);
  }
  for (std::size_t a = 0; a < 4; ++a)
    octave.axes[a] = {along, static_cast<double>(shifts[a]) * 0x1p-32, period};
  return octave;
}

}  // namespace verdigris::synthesis
