#pragma once
// Values as a scene file holds them.

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "verdigris/base/parameters.hpp"

namespace verdigris::io {

/// 17 digits bring back the same double; always with a point or exponent, so that TOML reads a float.
inline std::string exact(double value) {
  std::string text = fmt::format("{:.17g}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

inline std::string written(const ParameterValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? quoted(*text) : exact(std::get<double>(value));
}

inline std::string path_from(const std::filesystem::path& file, const std::filesystem::path& target) {
  // Only folders are resolved: a model's own name may be a link, and its extension is needed.
  const auto folder_of = [](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path).parent_path());
  };
  const auto there = folder_of(target) / target.filename();
  const auto relative = there.lexically_relative(folder_of(file));
  return quoted((relative.empty() ? there : relative).generic_string());
}

}  // namespace verdigris::io
