// A behaviour from outside the library: register it, and it runs by name with the parameters it describes.
#include <verdigris/behaviours/builtin.hpp>
#include <verdigris/io/read_mesh.hpp>

#include <cstdio>

using namespace verdigris;

// A cell takes the state that most of the nine cells around it and itself have.
struct Majority {
  static constexpr const char* name = "majority";
  static constexpr const char* summary = "each cell follows most of its neighbourhood";
  using State = std::uint8_t;
  double share = 0.5;

  template <typename V>
  void parameters(V&& v) {
    v("share", share, 0.0, 1.0, "1", "share of cells that are 1 at first");
  }
  State outside() const { return 0; }
  State initial(const CellRandom& random) const { return random.words(1)[0] < threshold(share); }
  State next(const Neighbourhood<State>& n, const CellRandom&) const {
    int ones = n.centre();
    for (int k = 0; k < 4; ++k) ones += n.side(k) + n.corner(k);
    return ones > 4;
  }
};

static int failures = 0;
static void expect(bool holds, const char* what) {
  if (!holds) std::printf("not so: %s\n", what), ++failures;
}

// The cells that are 1 after twenty steps, and whether each step changed fewer cells than the first.
static std::size_t ones_after_twenty(const Catalogue& catalogue, const Surface& surface, double share,
                                     std::uint64_t& first) {
  const auto simulation = catalogue.find("majority").create({surface, 7, {}, {}}, {{"share", share}});
  first = simulation->step().changed;
  while (simulation->steps() < 20) expect(simulation->step().changed <= first, "the first step changes most");
  const Field<std::int32_t> state = simulation->field("state");
  std::size_t ones = 0;
  for (const Row& row : surface.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) ones += state[slot] == 1;
  return ones;
}

int main() {
  Catalogue catalogue = builtin_catalogue();
  catalogue.add<Majority>();
  expect(catalogue.entries().size() > 1 && catalogue.find("majority").parameters.at(0).name == "share",
         "it is listed");

  const Mesh mesh = read_mesh("bunny.obj");
  const Surface surface = make_surface(mesh, {.cell_size = cell_size_for(mesh, 20000)});
  std::uint64_t changed = 0;
  expect(ones_after_twenty(catalogue, surface, 1.0, changed) == surface.owned_count() && changed == 0,
         "all stay 1");
  expect(ones_after_twenty(catalogue, surface, 0.0, changed) == 0 && changed == 0, "all stay 0");
  const std::size_t few = ones_after_twenty(catalogue, surface, 0.3, changed);
  const std::size_t many = ones_after_twenty(catalogue, surface, 0.7, changed);
  expect(few < surface.owned_count() / 10 && many > surface.owned_count() * 9 / 10, "a majority grows");
  try {
    catalogue.find("majority").create({surface, 7, {}, {}}, {{"share", 2.0}});
    expect(false, "a value out of range is refused");
  } catch (const std::exception& error) {
    std::printf("refused, as it should be: %s\n", error.what());
  }
  return failures;
}
