/// What a terminal can show, by what the environment says of it.
#pragma once

#include <string>

namespace app {

/// What may be written to a stream beside plain lines.
struct Terminal {
  bool animated = false;  ///< a line may be written over
  bool coloured = false;
};

/// @param is_terminal  of the stream.   @param no_color, term  values of NO_COLOR and TERM; null = not set.
[[nodiscard]] Terminal terminal_with(bool is_terminal, const char* no_color, const char* term);

/// Of a stream of this process, by what the environment says of it.
[[nodiscard]] Terminal terminal_at(int stream);

/// What LC_ALL, LC_CTYPE, LANG, TERM and NO_COLOR say.
struct TerminalEnvironment {
  std::string locale;     ///< the first that is set of LC_ALL, LC_CTYPE and LANG; empty = none
  std::string kind;       ///< TERM
  bool no_color = false;  ///< NO_COLOR is set: whoever colours must not

  [[nodiscard]] bool is_utf8() const;
  [[nodiscard]] bool has_colours() const { return !no_color && !kind.empty() && kind != "dumb"; }
};
[[nodiscard]] TerminalEnvironment terminal_environment();

/// The text in red, where that is wanted.
[[nodiscard]] std::string in_red(const std::string& text, bool coloured);

/// A help whose headings stand out, where that is wanted: lines that begin with a letter and end with ":".
[[nodiscard]] std::string with_headings(const std::string& help, bool coloured);

}  // namespace app
