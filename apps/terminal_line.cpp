#include "apps/terminal_line.hpp"

namespace app {
namespace {

constexpr const char* wipe = "\r\x1b[K";
constexpr std::size_t longest = 79;

}  // namespace

void TerminalLine::show(const std::string& text) {
  if (!enabled_) return;
  terminal_ << wipe << text.substr(0, longest) << std::flush;
  drawn_ = true;
}

TerminalLine::~TerminalLine() {
  if (drawn_) terminal_ << wipe << std::flush;
}

}  // namespace app
