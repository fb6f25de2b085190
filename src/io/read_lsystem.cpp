#include "verdigris/io/read_lsystem.hpp"

#include "file_bytes.hpp"

namespace verdigris {

LSystem read_lsystem(const std::filesystem::path& file) {
  io::FileBytes bytes = io::read_file(file);
  io::prepare_text(bytes, file);
  return parse_lsystem(bytes.view(), io::shown(file));
}

}  // namespace verdigris
