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

}  // namespace text_parts_test
