/// Checksums of a PNG put right after a mutation: else the reader stops at the first of them, and nothing
/// behind it is ever tried.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <cstdint>

namespace fuzz {

/// The 32 bits that PNG writes, highest byte first.
inline std::uint32_t big_endian(const std::uint8_t* p) {
  return std::uint32_t{p[0]} << 24U | std::uint32_t{p[1]} << 16U | std::uint32_t{p[2]} << 8U | p[3];
}

/// As far as there are whole chunks; bytes that are no PNG stay as they are.
inline void correct_png_checksums(std::uint8_t* bytes, std::size_t size) {
  constexpr std::size_t signature = 8, length = 4, name = 4, checksum = 4;
  if (size < signature || bytes[0] != 0x89 || bytes[1] != 'P') return;
  for (std::size_t at = signature; size - at >= length + name + checksum;) {
    const std::size_t data = big_endian(bytes + at);
    if (data > size - at - (length + name + checksum)) return;
    const std::size_t end = at + length + name + data;
    const auto sum = static_cast<std::uint32_t>(
        crc32(crc32(0, nullptr, 0), bytes + at + length, static_cast<uInt>(name + data)));
    for (unsigned i = 0; i < checksum; ++i) bytes[end + i] = static_cast<std::uint8_t>(sum >> (24U - 8U * i));
    at = end + checksum;
  }
}

}  // namespace fuzz
