#pragma once
// --threads of commands that make one thing and are not runs.

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <optional>

/// How many threads may work while it lives; 0: all cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads) {
    if (threads > 0)
      control_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }

 private:
  std::optional<tbb::global_control> control_;
};

inline void add_thread_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Threads to use (default: all cores); the result is the same")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
}
