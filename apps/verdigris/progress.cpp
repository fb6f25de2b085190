#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

Progress::Progress(bool show) : show_(show && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  finish();
}

void Progress::stage(const std::string& name) {
  finish();
  name_ = name;
  begun_ = Clock::now();
  printed_ = begun_ - std::chrono::seconds(1);
  update(0.0);
}

void Progress::update(double share, const std::string& note) {
  const auto now = Clock::now();
  if (!show_ || now - printed_ < std::chrono::milliseconds(100)) return;
  printed_ = now;
  open_ = true;
  const double elapsed = std::chrono::duration<double>(now - begun_).count();
  std::string line = fmt::format("{:<18}", name_);
  if (share > 0.0) line += fmt::format(" {:5.1f} %", 100.0 * share);
  // The estimate settles after a second; before that it would only jump.
  if (share > 0.001 && elapsed > 1.0) line += fmt::format("  {:.0f} s left", elapsed * (1.0 - share) / share);
  if (!note.empty()) line += "  " + note;
  say("\r\033[K{}", line);
  std::fflush(stderr);
}

void Progress::finish() {
  if (!open_) return;
  say("\r\033[K");
  std::fflush(stderr);
  open_ = false;
}

namespace {
std::atomic<bool> stop_requested{false};

void on_signal(int signal) {
  stop_requested.store(true, std::memory_order_relaxed);
  std::signal(signal, SIG_DFL);
}
}  // namespace

void watch_for_interrupt() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupted() {
  return stop_requested.load(std::memory_order_relaxed);
}
