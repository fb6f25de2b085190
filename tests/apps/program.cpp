#include "program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fs = std::filesystem;

Workplace::Workplace() {
  std::string name = (fs::temp_directory_path() / "verdigris-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
  directory_ = name;
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(directory_, ignored);
}

std::string Workplace::file(const std::string& name, const std::string& content) const {
  std::ofstream(path(name), std::ios::binary) << content;
  return path(name).string();
}

std::string Workplace::cube() const {
  return file("cube.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
              "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
}

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

Running::Running(const Arguments& arguments) {
  std::vector<char*> argv{const_cast<char*>(VERDIGRIS_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  // Made here, so that they are there even when the child is killed before it begins.
  const std::string out = place_.file("out", ""), err = place_.file("err", "");
  pid_ = ::fork();
  if (pid_ != 0) return;
  const auto redirect = [](const char* file, int flags, int to) { ::dup2(::open(file, flags, 0600), to); };
  redirect("/dev/null", O_RDONLY, STDIN_FILENO);
  redirect(out.c_str(), O_WRONLY | O_CREAT, STDOUT_FILENO);
  redirect(err.c_str(), O_WRONLY | O_CREAT, STDERR_FILENO);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

void Running::signal(int number) const {
  ::kill(pid_, number);
}

bool Running::ended() {
  if (pid_ > 0 && ::waitpid(pid_, &state_, WNOHANG) == pid_) pid_ = 0;
  return pid_ == 0;
}

Outcome Running::wait() {
  if (pid_ > 0) ::waitpid(pid_, &state_, 0);
  pid_ = 0;
  return {WIFEXITED(state_) ? WEXITSTATUS(state_) : 128 + WTERMSIG(state_), content_of(place_.path("out")),
          content_of(place_.path("err"))};
}

Outcome verdigris(const Arguments& arguments) {
  return Running(arguments).wait();
}

void expect_faults_refused(const std::string& command, const std::string& scene,
                           const std::vector<Fault>& faults, const Arguments& more) {
  for (const Fault& fault : faults) {
    const Workplace place;
    place.cube();
    std::string text = scene;
    text.replace(text.find(fault.what), std::string(fault.what).size(), fault.by);
    SCOPED_TRACE(fault.by);
    Arguments arguments{command, place.file("scene.toml", text), "--out", place.path("out")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refused(verdigris(arguments), fault.place, place.path("out"));
  }
}

void expect_refused(const Outcome& outcome, const std::string& place, const fs::path& out) {
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find(place), std::string::npos) << "'" << place << "' is not in:\n" << outcome.err;
  // Misused options are answered by the option parser, whose remedy is the help.
  EXPECT_TRUE(outcome.err.find("remedy: ") != std::string::npos ||
              outcome.err.find("--help") != std::string::npos)
      << outcome.err;
  EXPECT_TRUE(!fs::is_directory(out) || fs::is_empty(out)) << "left something in " << out;
  EXPECT_FALSE(fs::is_regular_file(out)) << "left " << out;
  fs::remove_all(out);
}
