/// Text files too large to be held in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "specimen/body/replace_file.hpp"

namespace exchange {

/// Collects text and hands it on in large pieces.
class TextStream {
 public:
  explicit TextStream(const specimen::ByteSink& sink) : sink_(sink) {}
  TextStream(const TextStream&) = delete;
  TextStream& operator=(const TextStream&) = delete;

  TextStream& operator<<(std::string_view text);
  TextStream& operator<<(std::int64_t number);
  /// Hand on what is left; to be called at the end.
  void flush();

 private:
  const specimen::ByteSink& sink_;
  std::string text_;
};

/// Put text on disk as `path`, wholly or not at all.   @throws specimen::Error (Fault::write).
void write_text(const std::string& path, const std::function<void(TextStream&)>& write);

/// A length [m] with 12 significant digits, within the 20 characters that a number may have in a mesh file.
[[nodiscard]] std::string length_text(double length);

}  // namespace exchange
