#pragma once
// Runs the program, and says what came of it.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

/// A directory of its own for one test, gone with it.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  std::filesystem::path path(const std::string& name) const { return directory_ / name; }
  /// Writes a file; returns its path.
  std::string file(const std::string& name, const std::string& content) const;
  /// A cube of side 1 as six squares: bottom, top, then front, right, back and left.
  std::string cube() const;

 private:
  std::filesystem::path directory_;
};

std::string content_of(const std::filesystem::path& file);

using Arguments = std::vector<std::string>;

struct Outcome {
  int status = -1;  ///< exit status; 128 + signal when one ended it
  std::string out, err;
};

/// `verdigris arguments...`, without standard input.
Outcome verdigris(const Arguments& arguments);

/// The same, not waited for.
class Running {
 public:
  explicit Running(const Arguments& arguments);
  void signal(int number) const;
  bool ended();
  Outcome wait();

 private:
  Workplace place_;
  pid_t pid_ = -1;
  int state_ = 0;
};

/// Something in a text that is put wrong, and what the message has to name then.
struct Fault {
  const char *what, *by, *place;
};

/// Expects `verdigris command scene.toml --out ... more` to refuse `scene`, a cube beside it, with each of
/// the faults alone.
void expect_faults_refused(const std::string& command, const std::string& scene,
                           const std::vector<Fault>& faults, const Arguments& more = {});

/// Fails unless the program refused its input as it should: status 2, nothing on standard output, on standard
/// error `place` and a remedy, no file in `out`.
void expect_refused(const Outcome& outcome, const std::string& place, const std::filesystem::path& out);
