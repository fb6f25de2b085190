#include "verdigris/automaton/checkpoint.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <memory>
#include <span>

#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

// XXH3 of numbers, in the byte order of the machine: only ever compared with what a like machine made.
class Digest {
 public:
  Digest() : state_(XXH3_createState(), &XXH3_freeState) { XXH3_128bits_reset(state_.get()); }

  template <typename T>
  void add(std::span<const T> values) {
    XXH3_128bits_update(state_.get(), values.data(), values.size_bytes());
  }
  template <typename T>
  void add(const T& value) {
    add(std::span(&value, 1));
  }
  std::string text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
  }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

// Where the cells lie in a field, and which follow which. States are kept by place, random numbers are keyed
// by it.
std::string hash_of(const Surface& surface) {
  Digest digest;
  digest.add(surface.rows());
  digest.add(surface.owned_runs());
  std::vector<std::uint32_t> batch;
  const auto flush = [&] {
    digest.add(std::span<const std::uint32_t>(batch));
    batch.clear();
  };
  surface.links().for_each([&](std::uint32_t source, auto targets) {
    batch.push_back(source);
    batch.insert(batch.end(), targets.begin(), targets.end());
    if (batch.size() > 4096) flush();
  });
  flush();
  return digest.text();
}

std::string described(const std::vector<Seed>& seeds) {
  Digest digest;
  for (const Seed& seed : seeds) {
    digest.add(seed.slot);
    digest.add(seed.weight);
  }
  return seeds.empty() ? "none" : fmt::format("{} ({})", seeds.size(), digest.text());
}

template <typename T>
std::string described(const Field<T>& values) {
  Digest digest;
  digest.add(std::span<const T>(values));
  return values.empty() ? "none" : digest.text();
}

}  // namespace

RunIdentity identity_of(const BehaviourEntry& behaviour, const SimulationSetup& setup,
                        const ParameterValues& values) {
  const Surface& surface = setup.surface;
  RunIdentity identity{{"mesh hash", mesh_hash(surface.mesh())},
                       {"cell size", fmt::format("{}", surface.cell_size())},
                       {"links", surface.link_kind() == LinkKind::unfolded ? "unfolded" : "projected"},
                       {"behaviour", behaviour.name}};
  for (const ParameterInfo& parameter : behaviour.parameters) {
    ParameterValue value = parameter.default_value;
    for (const auto& [name, given] : values)
      if (name == parameter.name) value = given;
    identity.emplace_back("parameter " + parameter.name, parameter_text(value));
  }
  identity.emplace_back("seed of the random numbers", fmt::format("{}", setup.seed));
  identity.emplace_back("seeds", described(setup.seeds));
  identity.emplace_back("barrier", described(setup.barrier));
  for (const Mask& mask : setup.masks) identity.emplace_back("mask " + mask.name, described(mask.values));
  identity.emplace_back("layout of the cells", hash_of(surface));
  return identity;
}

void check_identity(const std::string& where, const RunIdentity& saved, const RunIdentity& now) {
  const auto differ = [&](const std::string& what, const std::string& then, const std::string& here) {
    throw InputError(where, fmt::format("it is of another run: {} was {}, now {}", what, then, here),
                     "give model and options as they were then, or start again without this checkpoint");
  };
  const auto find = [](const RunIdentity& identity, const std::string& what) {
    return std::find_if(identity.begin(), identity.end(),
                        [&](const auto& pair) { return pair.first == what; });
  };
  for (const auto& [what, value] : now) {
    const auto then = find(saved, what);
    if (then == saved.end()) differ(what, "not there", value);
    if (then->second != value) differ(what, then->second, value);
  }
  for (const auto& [what, value] : saved)
    if (find(now, what) == now.end()) differ(what, value, "not there");
}

}  // namespace verdigris
