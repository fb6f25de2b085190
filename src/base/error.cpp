#include "verdigris/base/error.hpp"

#include <utility>

namespace verdigris {

namespace {
std::string sentence(const std::string& where, const std::string& problem, const std::string& remedy) {
  std::string text = where.empty() ? problem : where + ": " + problem;
  if (!remedy.empty()) text += "\n  remedy: " + remedy;
  return text;
}
}  // namespace

InputError::InputError(std::string where, std::string what, std::string remedy)
    : std::runtime_error(sentence(where, what, remedy)),
      where_(std::move(where)),
      problem_(std::move(what)),
      remedy_(std::move(remedy)) {}

}  // namespace verdigris
