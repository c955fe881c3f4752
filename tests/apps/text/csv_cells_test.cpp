#include "apps/text/text_parts.hpp"

#include <gtest/gtest.h>

namespace csv_cells_test {

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

}  // namespace csv_cells_test
