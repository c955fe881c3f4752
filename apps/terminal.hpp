/// What may be written to a stream beside plain lines.
#pragma once

#include <string>

namespace app {

struct Terminal {
  bool animated = false;  ///< a line may be written over
  bool coloured = false;
};

/// @param is_terminal  of the stream.   @param no_color, term  values of NO_COLOR and TERM; null = not set.
[[nodiscard]] Terminal terminal_with(bool is_terminal, const char* no_color, const char* term);

/// Of a stream of this process, by what the environment says of it.
[[nodiscard]] Terminal terminal_at(int stream);

/// The text in red, where that is wanted.
[[nodiscard]] std::string in_red(const std::string& text, bool coloured);

/// A help whose headings stand out, where that is wanted: lines that begin with a letter and end with ":".
[[nodiscard]] std::string with_headings(const std::string& help, bool coloured);

}  // namespace app
