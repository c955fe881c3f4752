#include "apps/system/terminal.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace terminal_test {

using app::terminal_with;

TEST(Terminal, ColoursAndMovesWhereItCan) {
  for (const char* term : {"xterm-256color", static_cast<const char*>(nullptr)}) {
    EXPECT_TRUE(terminal_with(true, nullptr, term).coloured);
    EXPECT_TRUE(terminal_with(true, nullptr, term).animated);
  }
}

TEST(Terminal, IsPlainWhereItIsNone) {
  EXPECT_FALSE(terminal_with(false, nullptr, "xterm").coloured);
  EXPECT_FALSE(terminal_with(false, nullptr, "xterm").animated);
}

TEST(Terminal, KeepsItsColoursBackWhereTheUserWantsNone) {
  EXPECT_FALSE(terminal_with(true, "1", "xterm").coloured);
  EXPECT_TRUE(terminal_with(true, "1", "xterm").animated);
  EXPECT_TRUE(terminal_with(true, "", "xterm").coloured);  // set to nothing is as good as not set
}

TEST(Terminal, ThatIsDumbGetsLinesAlone) {
  EXPECT_FALSE(terminal_with(true, nullptr, "dumb").coloured);
  EXPECT_FALSE(terminal_with(true, nullptr, "dumb").animated);
}

TEST(Terminal, HeadingsStandOutInAHelp) {
  const std::string help = "Usage: mesopix\n\nLoading:\n  --velocity:\n";
  EXPECT_EQ(app::with_headings(help, false), help);
  EXPECT_EQ(app::with_headings(help, true), "Usage: mesopix\n\n\x1b[1mLoading:\x1b[0m\n  --velocity:\n");
  EXPECT_EQ(app::in_red("mesopix:", true), "\x1b[1;31mmesopix:\x1b[0m");
  EXPECT_EQ(app::in_red("mesopix:", false), "mesopix:");
}

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

}  // namespace terminal_test
