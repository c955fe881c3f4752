#include "apps/text/markup.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace json_text_test {

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

}  // namespace json_text_test
