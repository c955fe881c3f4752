#include "apps/scene/toml.hpp"

#include <gtest/gtest.h>

#include "tests/apps/refusal.hpp"

namespace toml_nesting_test {

std::string many(const std::string& part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += part;
  return text;
}

/// Where a text nests too deep; "" where it does not.
std::string verdict(const std::string& text) {
  const std::string said = test::refusal([&] { app::check_nesting(text, "s.toml"); });
  return said.substr(0, said.find(" nested too deep"));
}

TEST(TomlNesting, OfOrdinaryTextsPasses) {
  EXPECT_EQ(verdict("[phases.itz]\nyoung = \"2 GPa\"\n[[ellipses]]\nx = 1.5\n"), "nothing");
  EXPECT_EQ(
      verdict("a = [" + many("1.5, ", 1000) + "]\nb = \"" + many("a.", 100) + "\" # " + many("b.", 100)),
      "nothing");
  EXPECT_EQ(verdict(many("a = [[1], {b.c = 2}]\n", 100)), "nothing") << "what is closed counts no more";
}

TEST(TomlNesting, TellsWhereAKeyHasTooManyParts) {
  EXPECT_EQ(verdict(many("a.", 15) + "a = 1"), "nothing");
  EXPECT_EQ(verdict("\n" + many("a.", 100'000) + "a = 1"), "s.toml:2:32:");
  EXPECT_EQ(verdict("[" + many(" \"a\" .", 100) + "a]"), "s.toml:1:97:");
  EXPECT_EQ(verdict("x = {" + many("'a' .", 100) + "a = 1}"), "s.toml:1:85:");
}

TEST(TomlNesting, TellsWhereListsLieTooDeep) {
  EXPECT_EQ(verdict("a = " + many("[", 32) + many("]", 32)), "nothing");
  EXPECT_EQ(verdict("a = " + many("[", 100'000)), "s.toml:1:37:");
  EXPECT_EQ(verdict("a = " + many("{b = [", 100)), "s.toml:1:101:");
}

/// Else a quote in a string would hide the key behind it.
TEST(TomlNesting, KnowsWhereAStringEnds) {
  const std::string deep = many("b.", 100) + "b = 1";
  for (const std::string value : {R"("a\"b")", R"('a\')", R"("""a"b""c""")", R"("""a\"""b"""")",
                                  R"('''a'b"''''')", R"("")", R"("""""")", "\"\"\"a\n\"b\n\"\"\"", "\"cut\n"})
    EXPECT_NE(verdict("a = " + value + "\n" + deep), "nothing") << value;
  EXPECT_EQ(verdict("a = \"\"\"\n" + deep + "\n\"\"\""), "nothing") << "all of it a string";
}

}  // namespace toml_nesting_test
