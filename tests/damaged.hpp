/// Small good files, damaged in every way that a loop can think of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace test {

/// Gives try_it() the bytes with one bit turned over, of one byte in every `step`.
template <class Try>
void flip_bits(const std::string& good, std::size_t step, Try try_it) {
  for (std::size_t i = 0; i < good.size(); i += step) {
    std::string bytes = good;
    bytes[i] = static_cast<char>(bytes[i] ^ (1 << i / step % 8));
    try_it(bytes);
  }
}

/// Gives try_it() the bytes with one bit turned over, `count` times, anywhere.
template <class Try>
void flip_random_bits(const std::string& good, int count, Try try_it) {
  std::mt19937_64 random(1);
  for (int i = 0; i < count; ++i) {
    const std::uint64_t bit = random() % (8 * good.size());
    std::string bytes = good;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    try_it(bytes);
  }
}

/// A file of libmpm as HDF5 alone would have written it, without the seal at its end.
inline std::string unsealed(const std::string& bytes) { return bytes.substr(0, bytes.rfind("\nMPXSEAL")); }

/// Gives try_it() every beginning of a text, and the text with each of its letters replaced by marks that
/// mean something, by bytes that mean nothing, and by nothing.
template <class Try>
void damage_text(const std::string& good, Try try_it) {
  for (std::size_t i = 0; i <= good.size(); ++i) try_it(good.substr(0, i));
  constexpr std::array<std::string_view, 14> marks{
      "", "\"", "'", "[", "]", "{", "=", ",", ".", "\n", "9", "-", "\xff", std::string_view("\0", 1)};
  for (std::size_t i = 0; i < good.size(); ++i)
    for (const std::string_view mark : marks)
      try_it(good.substr(0, i) + std::string(mark) + good.substr(i + 1));
}

}  // namespace test
