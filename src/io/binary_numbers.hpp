#pragma once
// Numbers out of bytes, whatever the byte order of file and machine.

#include <algorithm>
#include <bit>
#include <cstring>

namespace verdigris::io {

/// The number at `from`, which needs no alignment. The caller has checked that its bytes are there.
template <class T>
T load(const char* from, bool big_endian) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, from, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

}  // namespace verdigris::io
