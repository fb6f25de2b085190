#pragma once
// What the library throws when an input cannot be used.

#include <stdexcept>
#include <string>

namespace verdigris {

/// Bad input, said so that a user can act on it: where (a file, "file:line", an option), what is wrong,
/// and what to do about it. Programs print what() and leave with status 2.
class InputError : public std::runtime_error {
 public:
  InputError(std::string where, std::string what, std::string remedy);

  const std::string& where() const { return where_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }

 private:
  std::string where_, problem_, remedy_;
};

}  // namespace verdigris
