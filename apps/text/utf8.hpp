/// Text of others as UTF-8 that a terminal, TOML and JSON can be given.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace app {

/// Bytes of the character that a text begins with; 0 where it begins with none (RFC 3629: no overlong forms,
/// no surrogates, nothing above U+10FFFF).
[[nodiscard]] std::size_t character_length(std::string_view text);

/// Text in double quotes with control characters escaped, so that it stays on its line; also a TOML string.
[[nodiscard]] std::string quoted(const std::string& text);

/// Whether the bytes are UTF-8, as TOML and JSON need them.
[[nodiscard]] bool is_utf8(const std::string& text);

/// Text without control characters and bytes that are no UTF-8 (they become "?"), for what is shown as the
/// user wrote it: a terminal obeys some of them, the C1 set among them, and others turn the direction of the
/// line round.
[[nodiscard]] std::string printable(const std::string& text);

/// The same, but for line breaks, which stay.
[[nodiscard]] std::string printable_lines(const std::string& text);

/// Text with its control characters as \u009B, as TOML and JSON take them within quotes.
[[nodiscard]] std::string escaped_controls(const std::string& text);

}  // namespace app
