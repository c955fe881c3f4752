#include "libmpm/hdf5_heap.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

#include "libmpm/hdf5_handle.hpp"

namespace mpm::hdf5 {
namespace {

constexpr std::string_view signature("GCOL\1", 5);  ///< with the only version that there is
constexpr std::uint64_t header_size = 16;           ///< of the heap, and of each object in it [bytes]
constexpr const char* damaged = "its texts are damaged";

std::uint64_t number(const char* bytes, int width) {
  std::uint64_t value = 0;
  for (int i = width - 1; i >= 0; --i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// A header that lies at a place of the file.
std::array<char, header_size> header_at(std::ifstream& file, std::uint64_t place) {
  std::array<char, header_size> header{};
  file.clear();
  file.seekg(static_cast<std::streamoff>(place));
  file.read(header.data(), header.size());
  require(file.good(), damaged);
  return header;
}

/// Objects follow each other up to the end of the heap; number 0 is the free space, which counts its header.
void require_sound_heap(std::ifstream& file, std::uint64_t begin, std::uint64_t file_size) {
  const std::uint64_t size = number(&header_at(file, begin)[8], 8);
  require(size >= header_size && size <= file_size - begin, damaged);
  const std::uint64_t end = begin + size;
  for (std::uint64_t at = begin + header_size; end - at >= header_size;) {
    const auto header = header_at(file, at);
    const bool is_free = number(header.data(), 2) == 0;
    const std::uint64_t length = number(&header[8], 8);
    require(length <= end - at, damaged);
    const std::uint64_t need = is_free ? length : header_size + (length + 7) / 8 * 8;
    require(need >= header_size && need <= end - at, damaged);
    at += need;
  }
}

}  // namespace

void require_sound_heaps(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file.is_open()) return;
  const auto file_size = static_cast<std::uint64_t>(file.tellg());
  // Blocks overlap, so that no signature is cut in two.
  constexpr std::uint64_t step = std::uint64_t{1} << 20U;
  std::string block;
  for (std::uint64_t begin = 0; begin < file_size; begin += step) {
    block.resize(std::min(step + signature.size() - 1, file_size - begin));
    file.clear();
    file.seekg(static_cast<std::streamoff>(begin));
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    for (std::size_t at = block.find(signature); at != std::string::npos; at = block.find(signature, at + 1))
      require_sound_heap(file, begin + at, file_size);
  }
}

}  // namespace mpm::hdf5
