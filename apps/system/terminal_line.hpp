/// One line on the terminal that is written over and over.
#pragma once

#include <ostream>
#include <string>

namespace app {

inline constexpr const char* wipe_line = "\r\x1b[K";  ///< and go back to its beginning

/// Wiped at the end. Texts are cut to 79 letters, since a line that is broken cannot be wiped.
class TerminalLine {
 public:
  TerminalLine(std::ostream& terminal, bool enabled) : terminal_(terminal), enabled_(enabled) {}
  ~TerminalLine();
  TerminalLine(const TerminalLine&) = delete;
  TerminalLine& operator=(const TerminalLine&) = delete;

  void show(const std::string& text);

 private:
  std::ostream& terminal_;
  bool enabled_;
  bool drawn_ = false;
};

}  // namespace app
