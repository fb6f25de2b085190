// Samples a second of every primitive, on one thread: a 512 x 512 section through space.

#include "samples.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace {

using namespace verdigris;

void primitive(benchmark::State& state, const PrimitiveEntry& entry, const ParameterValues& values) {
  bench::sample(state, *entry.create(values, 1));
}

void add(const PrimitiveEntry& entry, const std::string& variant, const ParameterValues& values) {
  benchmark::RegisterBenchmark((entry.name + variant).c_str(), primitive, entry, values)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const PrimitiveCatalogue catalogue = builtin_primitives();
  for (const PrimitiveEntry& entry : catalogue.entries()) {
    add(entry, "", {});
    for (const ParameterInfo& p : entry.parameters)
      if (p.name == "dimensions")
        for (double d = p.least; d <= p.greatest; ++d)
          add(entry, "/" + parameter_text(d) + "D", {{p.name, d}});
  }
  benchmark::RunSpecifiedBenchmarks();
}
