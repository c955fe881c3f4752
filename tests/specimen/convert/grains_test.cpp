#include "specimen/convert/grains.hpp"

#include <gtest/gtest.h>

#include "tests/specimen/drawn.hpp"

namespace grains_test {

using specimen_test::cells_of;
using specimen_test::text_of;
using Rows = std::vector<std::string>;

TEST(Grains, NumbersPiecesInReadingOrderAndKeepsTouchingValuesApart) {
  auto cells = cells_of({"..a.a", "a..a.", "77.88", "77888"});
  EXPECT_EQ(specimen::number_grains(cells), 6);
  EXPECT_EQ(text_of(cells), (Rows{"..1.2", "3..4.", "55.66", "55666"}));
  EXPECT_EQ(specimen::grain_numbers(cells), (std::vector<std::int32_t>{1, 2, 3, 4, 5, 6}));
}

}  // namespace grains_test
