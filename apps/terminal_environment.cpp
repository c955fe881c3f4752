#include "apps/terminal_environment.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace app {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

bool TerminalEnvironment::is_utf8() const {
  std::string letters;
  for (const char c : locale)
    if (c != '-') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters.find("utf8") != std::string::npos;
}

TerminalEnvironment terminal_environment() {
  TerminalEnvironment environment;
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"})
    if (environment.locale.empty()) environment.locale = variable(name);
  environment.kind = variable("TERM");
  environment.no_color = !variable("NO_COLOR").empty();
  return environment;
}

}  // namespace app
