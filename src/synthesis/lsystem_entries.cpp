#include "entries.hpp"
#include "line_field.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/lsystem.hpp"

namespace verdigris {

namespace {

struct LSystemPrimitive {
  static constexpr const char *name = "lsystem", *summary = "how near a point is to an L-system's drawing";
  static constexpr int dimension = 3;
  std::string preset = "plant", grammar;
  int iterations = -1;
  double angle = -1.0, falloff = 0.01;

  template <typename V>
  void parameters(V&& v) {
    std::vector<std::string> names;
    for (const LSystemPreset& p : lsystem_presets()) names.emplace_back(p.name);
    v("preset", preset, std::move(names), "which one of those that come with the library");
    v("grammar", grammar, {}, "one of your own instead, its lines as in a grammar file");
    v("iterations", iterations, -1, 1000, "1", "how often the word is rewritten; -1: as the L-system says");
    v("angle", angle, -1.0, 360.0, "degree", "of + and -; -1: as the L-system says");
    v("falloff", falloff, 1e-3, 0.4, "1",
      "distance from the lines at which it is 0, the drawing being 1 large");
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const {
    LSystem system = grammar.empty() ? named_lsystem(preset) : parse_lsystem(grammar, "lsystem.grammar");
    if (angle >= 0.0) system.turtle.angle = angle;
    const Word word = rewrite(system.grammar, iterations < 0 ? system.iterations : iterations, seed,
                              {.most = 4'000'000, .most_in_all = 40'000'000});
    return std::make_unique<synthesis::LineField>(draw_word(word, system.turtle), falloff);
  }
};

}  // namespace

void add_lsystems(PrimitiveCatalogue& catalogue) {
  catalogue.add(primitive_entry<LSystemPrimitive>());
}

}  // namespace verdigris
