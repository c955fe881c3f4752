#include "apps/system/terminal.hpp"

#include <unistd.h>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace app {
namespace {

constexpr const char* red = "\x1b[1;31m";
constexpr const char* bold = "\x1b[1m";
constexpr const char* plain = "\x1b[0m";

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

Terminal terminal_with(bool is_terminal, const char* no_color, const char* term) {
  const bool able = is_terminal && (term == nullptr || std::string_view(term) != "dumb");
  return {able, able && (no_color == nullptr || *no_color == '\0')};
}

Terminal terminal_at(int stream) {
  return terminal_with(isatty(stream) != 0, std::getenv("NO_COLOR"), std::getenv("TERM"));
}

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

std::string in_red(const std::string& text, bool coloured) { return coloured ? red + text + plain : text; }

std::string with_headings(const std::string& help, bool coloured) {
  if (!coloured) return help;
  std::string made;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    const bool heading = !line.empty() && line.front() != ' ' && line.back() == ':';
    made += (heading ? bold + line + plain : line) + "\n";
  }
  return made;
}

namespace {

constexpr std::size_t longest = 79;

}  // namespace

void TerminalLine::show(const std::string& text) {
  if (!enabled_) return;
  terminal_ << wipe_line << text.substr(0, longest) << std::flush;
  drawn_ = true;
}

TerminalLine::~TerminalLine() {
  if (drawn_) terminal_ << wipe_line << std::flush;
}

}  // namespace app
