#include "restart_step.hpp"

#include "verdigris/io/checkpoint_file.hpp"

std::uint64_t checkpoint_step(const std::filesystem::path& file) {
  return verdigris::read_checkpoint(file).state.step;
}
