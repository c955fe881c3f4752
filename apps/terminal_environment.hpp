/// What the environment says of the terminal.
#pragma once

#include <string>

namespace app {

struct TerminalEnvironment {
  std::string locale;     ///< the first that is set of LC_ALL, LC_CTYPE and LANG; empty = none
  std::string kind;       ///< TERM
  bool no_color = false;  ///< NO_COLOR is set: whoever colours must not

  [[nodiscard]] bool is_utf8() const;
  [[nodiscard]] bool has_colours() const { return !no_color && !kind.empty() && kind != "dumb"; }
};

[[nodiscard]] TerminalEnvironment terminal_environment();

}  // namespace app
