#pragma once
// Another program, run beside this one.

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace verdigris::io {

/// A running program. No shell is between: arguments are what they are. It does not hear of Ctrl-C; the
/// destructor ends it.
class ChildProcess {
 public:
  /// `arguments[0]` is looked for on the PATH. Throws std::system_error when it cannot be started.
  explicit ChildProcess(const std::vector<std::string>& arguments);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes to its standard input. False when it no longer listens.
  bool write(std::string_view bytes);
  void end_input();
  /// Waits for its end. Its exit status; 128 + signal when one ended it.
  int wait();
  /// What it wrote to standard output and standard error until now.
  std::string output() const;
  std::string errors() const;

 private:
  pid_t process_ = -1;
  int status_ = 0, input_ = -1;
  std::FILE *output_ = nullptr, *errors_ = nullptr;
};

}  // namespace verdigris::io
