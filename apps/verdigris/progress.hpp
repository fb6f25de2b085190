#pragma once
// What a person at a terminal sees of long work, and how they stop it.

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <utility>

/// Progress of one stage on standard error, rewritten in place; silent when that is no terminal.
class Progress {
 public:
  /// `show` false: never prints.
  explicit Progress(bool show);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& name);
  /// Share of the stage done, 0..1, and a word on it; prints at most ten times a second.
  void update(double share, const std::string& note = "");
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  bool show_;
  bool open_ = false;
  std::string name_;
  Clock::time_point begun_, printed_;
};

/// Writes to standard error, and goes on where that cannot be done: a closed terminal must not end a run.
template <typename... Args>
void say(fmt::format_string<Args...> text, Args&&... args) {
  std::fputs(fmt::format(text, std::forward<Args>(args)...).c_str(), stderr);
}

/// From now on Ctrl-C and SIGTERM only ask to stop; the second one ends the program at once.
void watch_for_interrupt();
bool interrupted();
