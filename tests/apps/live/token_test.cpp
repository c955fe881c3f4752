#include "apps/live/live_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace token_test {

TEST(Token, IsLongAndNeverTheSame) {
  const std::string token = app::random_token();
  EXPECT_THAT(token, testing::MatchesRegex("[0-9a-f]+"));
  EXPECT_EQ(token.size(), 32U);
  EXPECT_NE(token, app::random_token());
}

TEST(Token, IsTheSameInEveryLetterOnly) {
  EXPECT_TRUE(app::same_secret("0123abcd", "0123abcd"));
  EXPECT_FALSE(app::same_secret("0123abce", "0123abcd"));
  EXPECT_FALSE(app::same_secret("1123abcd", "0123abcd"));
  EXPECT_FALSE(app::same_secret("0123abc", "0123abcd"));
  EXPECT_FALSE(app::same_secret("0123abcd0", "0123abcd"));
  EXPECT_FALSE(app::same_secret("", "0123abcd"));
}

}  // namespace token_test
