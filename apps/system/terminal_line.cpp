#include "apps/system/terminal_line.hpp"

namespace app {
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
