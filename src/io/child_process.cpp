#include "child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace verdigris::io {

namespace {

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

// A file, not a pipe: it can be long, and nobody reads it until the end.
std::FILE* unnamed_file() {
  std::FILE* file = std::tmpfile();
  if (file == nullptr) fail(errno, "a temporary file");
  ::fcntl(::fileno(file), F_SETFD, FD_CLOEXEC);
  return file;
}

std::string content_of(std::FILE* file) {
  std::string text;
  std::array<char, 4096> block;
  ::lseek(::fileno(file), 0, SEEK_SET);
  for (ssize_t n = 0; (n = ::read(::fileno(file), block.data(), block.size())) > 0;)
    text.append(block.data(), static_cast<std::size_t>(n));
  return text;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments)
    : output_(unnamed_file()), errors_(unnamed_file()) {
  // A socket for its input: writing to one that is gone is an error, not a signal.
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    const int error = errno;
    std::fclose(output_);
    std::fclose(errors_);
    fail(error, "a pipe");
  }
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(output_), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, ::fileno(errors_), STDERR_FILENO);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // a group of its own: no Ctrl-C
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const int error = ::posix_spawnp(&process_, argv[0], &actions, &attributes, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  ::close(ends[1]);
  input_ = ends[0];
  if (error == 0) return;
  ::close(input_);
  std::fclose(output_);
  std::fclose(errors_);
  fail(error, arguments[0]);
}

ChildProcess::~ChildProcess() {
  end_input();
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    wait();
  }
  std::fclose(output_);
  std::fclose(errors_);
}

bool ChildProcess::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

void ChildProcess::end_input() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
}

int ChildProcess::wait() {
  if (process_ <= 0) return status_;
  int state = 0;
  while (::waitpid(process_, &state, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  status_ = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
  return status_;
}

std::string ChildProcess::output() const {
  return content_of(output_);
}

std::string ChildProcess::errors() const {
  return content_of(errors_);
}

}  // namespace verdigris::io
