#pragma once
// Another program, run beside this one.

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace verdigris::io {

/// A running program. No shell is between: arguments are what they are. It has no standard input, and does
/// not hear of Ctrl-C; the destructor ends it.
class ChildProcess {
 public:
  /// `arguments[0]` is looked for on the PATH. `directory` is where it runs; empty: here. Throws
  /// std::system_error when it cannot be started.
  explicit ChildProcess(const std::vector<std::string>& arguments,
                        const std::filesystem::path& directory = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The next line of its standard output, without its end; none when there are no more. Waits for it.
  std::optional<std::string> line();
  /// Asks it to end.
  void stop();
  /// Waits for its end. Its exit status; 128 + signal when one ended it.
  int wait();
  /// What it wrote to standard error until now.
  std::string errors();

 private:
  pid_t process_ = -1;
  int status_ = 0;
  std::FILE *output_ = nullptr, *errors_ = nullptr;
};

}  // namespace verdigris::io
