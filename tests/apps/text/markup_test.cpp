#include "apps/text/markup.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace markup_test {

TEST(Escape, TakesTheMeaningFromEveryMark) {
  EXPECT_EQ(output::escape("</script><script>alert(1)</script>"),
            "&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;");
  EXPECT_EQ(output::escape("a & \"b\" 'c'"), "a &amp; &quot;b&quot; &#39;c&#39;");
}

TEST(Escape, KeepsEveryLengthOfUtf8) {
  const std::string text = "a\tµ €\n\U0001F9F1";
  EXPECT_EQ(output::escape(text), text);
}

TEST(Escape, ReplacesControlCharacters) {
  EXPECT_EQ(output::escape(std::string("a\0b", 3)), "a\uFFFDb");
  EXPECT_EQ(output::escape("\x1b[31m\x7f"), "\uFFFD[31m\uFFFD");
}

TEST(Escape, ReplacesBytesThatAreNoUtf8) {
  EXPECT_EQ(output::escape("a\xFF"), "a\uFFFD");
  EXPECT_EQ(output::escape("\xC3"), "\uFFFD") << "cut short";
  EXPECT_EQ(output::escape("\xC3<"), "\uFFFD&lt;") << "a mark must not hide behind a broken byte";
  EXPECT_EQ(output::escape("\xC0\xBC"), "\uFFFD\uFFFD") << "an overlong <";
  EXPECT_EQ(output::escape("\xE0\x80\xBC"), "\uFFFD\uFFFD\uFFFD") << "an overlong <";
  EXPECT_EQ(output::escape("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD") << "a surrogate";
  EXPECT_EQ(output::escape("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD") << "above U+10FFFF";
}

// Source: RFC 4648, section 10.
TEST(PngAddress, EncodesTheTestVectorsOfTheStandard) {
  const std::string head = "data:image/png;base64,";
  EXPECT_EQ(output::png_address(""), head);
  EXPECT_EQ(output::png_address("f"), head + "Zg==");
  EXPECT_EQ(output::png_address("fo"), head + "Zm8=");
  EXPECT_EQ(output::png_address("foo"), head + "Zm9v");
  EXPECT_EQ(output::png_address("foob"), head + "Zm9vYg==");
  EXPECT_EQ(output::png_address("fooba"), head + "Zm9vYmE=");
  EXPECT_EQ(output::png_address("foobar"), head + "Zm9vYmFy");
  EXPECT_EQ(output::png_address("\xFB\xFF\xFE"), head + "+//+");
}

TEST(JsonText, IsIndentedAndEndsItsLine) {
  EXPECT_EQ(app::json_text({{"b", 1}, {"a", {2, 3}}}), "{\n  \"b\": 1,\n  \"a\": [\n    2,\n    3\n  ]\n}\n");
}

TEST(JsonText, HoldsNothingThatATerminalObeysAndSaysTheSame) {
  const nlohmann::ordered_json json{{"name\x1b[2J",
                                     "\xC2\x9B"
                                     "31m\x7F\n caf\xC3\xA9"}};
  const std::string text = app::json_text(json);
  EXPECT_EQ(text, "{\n  \"name\\u001b[2J\": \"\\u009B31m\\u007F\\n caf\xC3\xA9\"\n}\n");
  EXPECT_EQ(nlohmann::ordered_json::parse(text), json);
}

TEST(JsonText, ReplacesWhatIsNoText) { EXPECT_EQ(app::json_text("caf\xE9"), "\"caf\xEF\xBF\xBD\"\n"); }

}  // namespace markup_test
