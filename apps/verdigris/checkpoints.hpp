#pragma once
// Checkpoints of a run: when they are due, written while the run goes on, and taken up again.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <future>
#include <string>

#include "verdigris/automaton/checkpoint.hpp"

/// How often to write one. Both 0: only when the run is stopped.
struct CheckpointInterval {
  std::uint64_t steps = 0;
  double seconds = 0.0;
};

/// "500" (steps), "30s", "5m", "2h", or nothing. Throws InputError.
CheckpointInterval parse_interval(const std::string& text);

/// Writes the checkpoints of one run.
class CheckpointWriter {
 public:
  CheckpointWriter(std::filesystem::path file, const CheckpointInterval& every,
                   verdigris::RunIdentity identity);
  /// Waits for what is being written.
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  /// To be called after each step. Copies the state when a checkpoint is due; a thread of its own writes it.
  /// That a file could not be written is a warning on standard error: the run is worth more than its
  /// checkpoint.
  void after_step(const verdigris::AnySimulation& simulation);
  /// Writes one and waits for it. False when that failed.
  bool write_now(const verdigris::AnySimulation& simulation);
  /// Removes the checkpoint of a run that is complete.
  void remove();
  /// How long the run has stood still for checkpoints, seconds.
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  void begin_writing(const verdigris::AnySimulation& simulation);
  bool finish_writing();
  bool due(std::uint64_t steps) const;

  std::filesystem::path file_;
  CheckpointInterval every_;
  verdigris::RunIdentity identity_;
  Clock::time_point last_;
  double seconds_ = 0.0;
  std::future<void> writing_;
};

/// The checkpoint to go on from. Throws InputError when there is none, or when it stands at step `last_step`
/// (0: none) or later: then there is nothing left to do.
verdigris::Checkpoint checkpoint_to_resume(const std::filesystem::path& file, std::uint64_t last_step);

/// Makes `simulation` stand where `checkpoint` does. Throws InputError about `file` when they are of
/// different runs.
void resume(verdigris::AnySimulation& simulation, const verdigris::Checkpoint& checkpoint,
            const verdigris::RunIdentity& identity, const std::filesystem::path& file);
