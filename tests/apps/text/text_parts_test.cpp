#include "apps/text/text_parts.hpp"

#include <gtest/gtest.h>

namespace text_parts_test {

TEST(Trimmed, TakesBlanksFromTheEndsOnly) {
  EXPECT_EQ(app::trimmed(" \t5 mm \t"), "5 mm");
  EXPECT_EQ(app::trimmed("5 mm"), "5 mm");
  EXPECT_EQ(app::trimmed(" \t "), "");
  EXPECT_EQ(app::trimmed(""), "");
}

TEST(WholeNumber, IsTheWholeText) {
  EXPECT_EQ(app::whole_number("-12"), -12);
  EXPECT_EQ(app::whole_number("9223372036854775807"), INT64_MAX);
  for (const char* text : {"", " 1", "1 ", "+1", "1.0", "0x1", "9223372036854775808"})
    EXPECT_EQ(app::whole_number(text), std::nullopt) << '"' << text << '"';
}

TEST(CsvCells, TellsWhereEachBegins) {
  const auto cells = app::csv_cells(" a ,b c,,\td");
  ASSERT_EQ(cells.size(), 4u);
  EXPECT_EQ(cells[0].text, "a");
  EXPECT_EQ(cells[0].column, 2);
  EXPECT_EQ(cells[1].text, "b c");
  EXPECT_EQ(cells[1].column, 5);
  EXPECT_EQ(cells[2].text, "");
  EXPECT_EQ(cells[3].text, "d");
  EXPECT_EQ(cells[3].column, 11);
}

TEST(ShellWord, HasQuotesWhereItNeedsThem) {
  EXPECT_EQ(app::shell_word("runs/a-2_b.c,d:e=f+1"), "runs/a-2_b.c,d:e=f+1");
  EXPECT_EQ(app::shell_word("my runs"), "'my runs'");
  EXPECT_EQ(app::shell_word("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(app::shell_word(""), "''");
}

}  // namespace text_parts_test
