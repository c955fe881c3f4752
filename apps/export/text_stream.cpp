#include "apps/export/text_stream.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <span>

namespace exchange {
namespace {

constexpr std::size_t piece = std::size_t{1} << 20;  ///< [bytes]

}  // namespace

TextStream& TextStream::operator<<(std::string_view text) {
  text_.append(text);
  if (text_.size() >= piece) flush();
  return *this;
}

TextStream& TextStream::operator<<(std::int64_t number) {
  const fmt::format_int text(number);
  return *this << std::string_view(text.data(), text.size());
}

void TextStream::flush() {
  sink_(std::as_bytes(std::span(text_)));
  text_.clear();
}

void write_text(const std::string& path, const std::function<void(TextStream&)>& write) {
  specimen::replace_file(path, [&](const specimen::ByteSink& sink) {
    TextStream stream(sink);
    write(stream);
    stream.flush();
  });
}

std::string length_text(double length) { return fmt::format("{:.12g}", length); }

}  // namespace exchange
