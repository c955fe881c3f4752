#include "apps/scene/toml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/refusal.hpp"

namespace toml_test {

using testing::ElementsAre;

/// What remains of a text, and the lines of the complaints.
struct Left {
  std::string text;
  std::vector<int> lines;
  std::string gone;
};

Left left_of(const std::string& text) {
  const app::Parseable parts =
      app::parseable(text, [](const std::string& part) { (void)app::parse_toml(part, "a.toml"); });
  Left left{parts.text, {}, parts.left_out};
  for (const app::Complaint& one : parts.complaints) left.lines.push_back(one.place.line);
  return left;
}

TEST(Parseable, LeavesAGoodTextAlone) {
  const std::string good = "[a]\nb = [\n  1,\n  2,\n]\n\n[c]\nd = \"[x = {\"\n";
  EXPECT_EQ(left_of(good).text, good);
  EXPECT_THAT(left_of(good).lines, ElementsAre());
}

TEST(Parseable, LeavesOutEachStatementThatIsNone) {
  const Left left = left_of("a = 1\nb 2\nc = \"open\nd = 4\ne = \n");
  EXPECT_EQ(left.text, "a = 1\n\n\nd = 4\n\n");
  EXPECT_THAT(left.lines, ElementsAre(2, 3, 5));
  EXPECT_EQ(left.gone, "b 2\nc = \"open\ne = \n");
}

TEST(Parseable, KeepsTheFirstOfTwoWithOneName) {
  EXPECT_EQ(left_of("a = 1\na = 2\nb = 3\n").text, "a = 1\n\nb = 3\n");
}

TEST(Parseable, LeavesOutWhatStandsBelowABrokenHead) {
  const Left left = left_of("[a]\nb = 1\n[c\nd = 2\n\n[e]\nf = 3\n");
  EXPECT_EQ(left.text, "[a]\nb = 1\n\n\n\n[e]\nf = 3\n");
  EXPECT_EQ(left.lines.size(), 1u);
}

TEST(Parseable, FindsTheListThatIsNotClosed) {
  const Left left = left_of("a = [1,\n  2\n[b]\nc = 3\n");
  EXPECT_EQ(left.text, "\n\n[b]\nc = 3\n");
  EXPECT_EQ(left.lines.size(), 1u);
  EXPECT_EQ(left_of("a = [1, 2\nb = 3\n").text, "\nb = 3\n");
}

TEST(Parseable, LeavesOutAListWithABrokenItem) {
  EXPECT_EQ(left_of("a = [\n  {x = 1},\n  {x 1},\n]\nb = 2\n").text, "\n\n\n\nb = 2\n");
}

TEST(Parseable, GivesUpInTheEnd) {
  std::string text;
  for (int i = 0; i < 40; ++i) text += "a b\n";
  const Left left = left_of(text);
  EXPECT_EQ(left.text, "");
  EXPECT_EQ(left.lines.size(), 20u);
  EXPECT_EQ(left_of(std::string(2 << 20, '#') + "\na b\nc d\n").lines.size(), 1u);
}

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

}  // namespace toml_test
