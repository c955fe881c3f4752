#include "apps/text/text_parts.hpp"

#include <gtest/gtest.h>

namespace shell_word_test {

TEST(ShellWord, HasQuotesWhereItNeedsThem) {
  EXPECT_EQ(app::shell_word("runs/a-2_b.c,d:e=f+1"), "runs/a-2_b.c,d:e=f+1");
  EXPECT_EQ(app::shell_word("my runs"), "'my runs'");
  EXPECT_EQ(app::shell_word("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(app::shell_word(""), "''");
}

}  // namespace shell_word_test
