/// Where the program writes to, and how it words what it says.
#pragma once

#include <ostream>
#include <string>

#include "apps/settings/assignment.hpp"
#include "apps/text/complaint.hpp"

namespace app {

/// Results go to `out`, everything said to a person to `err`.
struct Console {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal = false;  ///< then a progress line may be drawn
  bool quiet = false;            ///< only errors
  Origins origins;               ///< of the settings, so that errors of the libraries can be located
  bool err_is_coloured = false;
  bool out_is_coloured = false;

  /// One line or more, unless quiet; whatever the terminal would obey is taken out.
  void say(const std::string& line) {
    if (!quiet) err << printable_lines(line) << '\n' << std::flush;
  }
};

}  // namespace app
