#include "libmpm/files/hdf5_heap.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace mpm::hdf5 {
namespace {

constexpr std::string_view signature("GCOL\1", 5);  ///< with the only version that there is
constexpr std::uint64_t header_size = 16;           ///< of the heap, and of each object in it [bytes]

std::uint64_t number(const char* bytes, int width) {
  std::uint64_t value = 0;
  for (int i = width - 1; i >= 0; --i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

class Heaps {
 public:
  explicit Heaps(const std::string& path) : file_(path, std::ios::binary | std::ios::ate) {
    if (!file_.is_open()) return;
    size_ = static_cast<std::uint64_t>(file_.tellg());
    objects_left_ = size_ / header_size;  // more than that only where heaps lie over each other
  }

  bool are_sound() {
    // Blocks overlap, so that no signature is cut in two.
    constexpr std::uint64_t step = std::uint64_t{1} << 20U;
    std::string block;
    for (std::uint64_t begin = 0; begin < size_; begin += step) {
      block.resize(std::min(step + signature.size() - 1, size_ - begin));
      if (!read(begin, block.data(), block.size())) return true;
      for (std::size_t at = block.find(signature); at != std::string::npos;
           at = block.find(signature, at + 1))
        if (!is_sound(begin + at)) return false;
    }
    return true;
  }

 private:
  bool read(std::uint64_t place, char* bytes, std::size_t count) {
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(place));
    return static_cast<bool>(file_.read(bytes, static_cast<std::streamsize>(count)));
  }

  bool is_sound(std::uint64_t begin) {
    std::array<char, header_size> header{};
    if (!read(begin, header.data(), header.size())) return true;
    const std::uint64_t size = number(&header[8], 8);
    // HDF5 itself refuses these; the letters may as well stand in the data by chance.
    if (size == 0 || size > size_ - begin) return true;
    return size >= header_size && objects_fill(begin + header_size, begin + size);
  }

  /// Objects follow each other up to the end of the heap; number 0 is the free space, which counts its
  /// header.
  bool objects_fill(std::uint64_t at, std::uint64_t end) {
    while (end - at >= header_size) {
      std::array<char, header_size> header{};
      if (objects_left_-- == 0 || !read(at, header.data(), header.size())) return false;
      const bool is_free = number(header.data(), 2) == 0;
      const std::uint64_t length = number(&header[8], 8);
      if (length > end - at) return false;
      const std::uint64_t need = is_free ? length : header_size + (length + 7) / 8 * 8;
      if (need < header_size || need > end - at) return false;
      at += need;
    }
    return true;
  }

  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::uint64_t objects_left_ = 0;
};

}  // namespace

bool heaps_are_sound(const std::string& path) { return Heaps(path).are_sound(); }

}  // namespace mpm::hdf5
