#include "checkpoints.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <exception>
#include <system_error>
#include <utility>

#include "progress.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/checkpoint_file.hpp"

using namespace verdigris;

CheckpointInterval parse_interval(const std::string& text) {
  CheckpointInterval every;
  if (text.empty()) return every;
  const char* const end = text.data() + text.size();
  if (const auto [rest, error] = std::from_chars(text.data(), end, every.steps);
      error == std::errc() && rest == end && every.steps > 0)
    return every;
  every.steps = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, every.seconds);
  const double unit = rest + 1 != end ? 0.0
                      : *rest == 's'  ? 1.0
                      : *rest == 'm'  ? 60.0
                      : *rest == 'h'  ? 3600.0
                                      : 0.0;
  every.seconds *= unit;
  if (error != std::errc() || !std::isfinite(every.seconds) || !(every.seconds > 0.0))
    throw InputError("--checkpoint-every", fmt::format("'{}' is neither a number of steps nor a time", text),
                     "write 500 (steps), 30s, 5m or 2h");
  return every;
}

CheckpointWriter::CheckpointWriter(std::filesystem::path file, const CheckpointInterval& every,
                                   RunIdentity identity)
    : file_(std::move(file)), every_(every), identity_(std::move(identity)), last_(Clock::now()) {}

CheckpointWriter::~CheckpointWriter() {
  finish_writing();
}

bool CheckpointWriter::due(std::uint64_t steps) const {
  // Counted from the first step of the run, not of this sitting: the files are the same wherever it was
  // stopped.
  if (every_.steps != 0) return steps % every_.steps == 0;
  if (!(every_.seconds > 0.0) || Clock::now() - last_ < std::chrono::duration<double>(every_.seconds))
    return false;
  // A disk slower than that is given the time it takes; the run does not wait for it.
  return !writing_.valid() || writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void CheckpointWriter::after_step(const AnySimulation& simulation) {
  if (!due(simulation.steps())) return;
  const auto begin = Clock::now();
  begin_writing(simulation);
  seconds_ += std::chrono::duration<double>(Clock::now() - begin).count();
}

bool CheckpointWriter::write_now(const AnySimulation& simulation) {
  try {
    begin_writing(simulation);
  } catch (const InputError& error) {
    say("warning: no checkpoint was written: {}\n", error.what());
    return false;
  }
  return finish_writing();
}

void CheckpointWriter::remove() {
  finish_writing();
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

void CheckpointWriter::begin_writing(const AnySimulation& simulation) {
  Checkpoint checkpoint{identity_, simulation.save()};
  finish_writing();  // one at a time: memory for two states, never more
  last_ = Clock::now();
  writing_ = std::async(std::launch::async,
                        [this, checkpoint = std::move(checkpoint)] { write_checkpoint(file_, checkpoint); });
}

bool CheckpointWriter::finish_writing() {
  if (!writing_.valid()) return true;
  try {
    writing_.get();
    return true;
  } catch (const std::exception& error) {
    say("warning: a checkpoint could not be written, the run goes on: {}\n", error.what());
    return false;
  }
}

Checkpoint checkpoint_to_resume(const std::filesystem::path& file, std::uint64_t last_step) {
  Checkpoint checkpoint = read_checkpoint(file);
  if (last_step != 0 && checkpoint.state.step >= last_step)
    throw InputError(
        file.string(),
        fmt::format("it stands at step {}, and the run is to end at step {}", checkpoint.state.step,
                    last_step),
        "ask for more steps, or do not limit them (a scene written when a run was stopped limits them), or "
        "start again without --resume");
  return checkpoint;
}

void resume(AnySimulation& simulation, const Checkpoint& checkpoint, const RunIdentity& identity,
            const std::filesystem::path& file) {
  check_identity(file.string(), checkpoint.identity, identity);
  try {
    simulation.restore(checkpoint.state);
  } catch (const InputError& error) {
    throw InputError(file.string(), error.problem(), error.remedy());
  }
}
