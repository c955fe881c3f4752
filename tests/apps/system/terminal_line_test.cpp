#include "apps/system/terminal.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace terminal_line_test {

TEST(TerminalLine, IsWrittenOverAndWipedAtTheEnd) {
  std::ostringstream terminal;
  {
    app::TerminalLine line(terminal, true);
    line.show("one");
    line.show("two");
  }
  EXPECT_EQ(terminal.str(), "\r\x1b[Kone\r\x1b[Ktwo\r\x1b[K");
}

TEST(TerminalLine, CutsWhatWouldNotFit) {
  std::ostringstream terminal;
  app::TerminalLine line(terminal, true);
  line.show(std::string(100, 'x'));
  EXPECT_EQ(terminal.str(), "\r\x1b[K" + std::string(79, 'x'));
}

TEST(TerminalLine, SaysNothingWhereThereIsNoTerminal) {
  std::ostringstream terminal;
  { app::TerminalLine(terminal, false).show("one"); }
  EXPECT_EQ(terminal.str(), "");
}

}  // namespace terminal_line_test
