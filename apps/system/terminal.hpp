/// Where the program writes to, what can be shown there, and how it words what it says.
#pragma once

#include <chrono>
#include <functional>
#include <ostream>
#include <string>

#include "apps/text/complaint.hpp"

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

/// Results go to `out`, everything said to a person to `err`.
struct Console {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal = false;  ///< then a progress line may be drawn
  bool quiet = false;            ///< only errors and warnings
  Locate locate;                 ///< where the user set what a library complains of; may be empty
  bool err_is_coloured = false;
  bool out_is_coloured = false;

  /// One line or more, unless quiet; whatever the terminal would obey is taken out.
  void say(const std::string& line) {
    if (!quiet) err << printable_lines(line) << '\n' << std::flush;
  }

  /// A line that is to be seen before the result is used: also when quiet.
  void warn(const std::string& line) { err << printable_lines("warning: " + line) << '\n' << std::flush; }
};

inline constexpr const char* wipe_line = "\r\x1b[K";  ///< and go back to its beginning

/// Wiped at the end. Texts are cut to 79 letters, since a line that is broken cannot be wiped.
class TerminalLine {
 public:
  TerminalLine(std::ostream& terminal, bool enabled) : terminal_(terminal), enabled_(enabled) {}
  /// Beside what is said there, where that is a terminal and not quiet.
  explicit TerminalLine(Console& console)
      : TerminalLine(console.err, console.err_is_terminal && !console.quiet) {}
  ~TerminalLine();
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  void show(const std::string& text);
  /// Since it was made [s].
  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::ostream& terminal_;
  bool enabled_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace app
