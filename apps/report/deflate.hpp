/// Bytes made small for a page.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace output {

/// In the zlib format, which browsers call "deflate", as base64.
/// @throws std::runtime_error when there is no memory for it.
[[nodiscard]] std::string deflated_base64(std::string_view bytes);

/// The bytes of an array as they lie in memory.   @pre the machine is little-endian, as the page expects.
template <class T>
[[nodiscard]] std::string deflated_base64(std::span<const T> values) {
  return deflated_base64(std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
}

}  // namespace output
