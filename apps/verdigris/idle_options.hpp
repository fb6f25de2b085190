#pragma once
// Options that would have no effect beside others are refused, not passed over in silence.

#include <CLI/CLI.hpp>
#include <initializer_list>

#include "verdigris/base/error.hpp"

/// Throws InputError with `problem` and `remedy` for the first of `names` that was given.
inline void refuse_idle(const CLI::App& command, std::initializer_list<const char*> names,
                        const char* problem, const char* remedy) {
  for (const char* name : names)
    if (command.count(name) > 0) throw verdigris::InputError(name, problem, remedy);
}
