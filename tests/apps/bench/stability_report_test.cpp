#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/bench/made_up_cases.hpp"

namespace stability_report_test {

using namespace app::bench;
using testing::HasSubstr;
using testing::Not;

StabilityOutcome interrupted_outcome() {
  return test::run_made_up({0, 1, 0}, 1, [calls = 0]() mutable { return ++calls < 3; });
}

TEST(StabilityReport, TextSaysWhatFailsAndSumsUp) {
  const std::string text = stability_text(test::run_made_up({0, 1, 2}));
  EXPECT_THAT(text, HasSubstr("First\n  holds    good      0.0 s\n           it holds\n"));
  EXPECT_THAT(text, HasSubstr("  FAILS    bad       0.0 s\n           it holds\n"));
  EXPECT_THAT(text, HasSubstr("NOT AS IT MUST BE: 3\n\nSecond\n"));
  EXPECT_THAT(text, HasSubstr("\n2 of 3 cases FAIL; 0 s, 1 at a time\n"));
  EXPECT_THAT(stability_text(test::run_made_up({0})), HasSubstr("\nall of 1 cases hold; 0 s, 1 at a time\n"));
}

TEST(StabilityReport, TextBreaksLongLinesBetweenWords) {
  StabilityOutcome outcome = test::run_made_up({0});
  outcome.rows[0].finding.seen =
      std::string(60, 'a') + ' ' + std::string(39, 'b') + ' ' + std::string(120, 'c');
  EXPECT_THAT(stability_text(outcome),
              HasSubstr("\n             " + std::string(60, 'a') + ' ' + std::string(39, 'b') +
                        "\n             " + std::string(120, 'c') + "\n"));
}

TEST(StabilityReport, TextTellsWhatWasNotRun) {
  const std::string text = stability_text(interrupted_outcome());
  EXPECT_THAT(text, HasSubstr("  not run  good"));
  EXPECT_THAT(text, HasSubstr("\n1 of 2 cases FAIL, 1 were not run; "));
}

TEST(StabilityReport, PageShowsEveryVerdictAndEscapes) {
  const std::string html = stability_html(test::run_made_up({0, 1, 2}));
  EXPECT_THAT(html, HasSubstr("<h2>First</h2>"));
  EXPECT_THAT(html, HasSubstr("<h2>Second</h2>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"verdict agrees\">holds</td>"));
  EXPECT_THAT(html, HasSubstr("<td class=\"verdict disagrees\">FAILS</td>"));
  EXPECT_THAT(html, HasSubstr("0.1 of &quot;1&quot;, &lt;fine&gt;"));
  EXPECT_THAT(html, HasSubstr("2 of 3 cases FAIL"));
  for (const char* part : {"href=", "src=\"http", "<script"}) EXPECT_THAT(html, Not(HasSubstr(part)));
  EXPECT_THAT(stability_html(interrupted_outcome()),
              HasSubstr("<td class=\"verdict disagrees\">not run</td>"));
}

TEST(StabilityReport, TableQuotesItsCells) {
  const std::string csv = stability_csv(test::run_made_up({0, 1}));
  EXPECT_EQ(csv.find("name,group,verdict,seconds,must,seen\ngood,First,holds,0.00,\"it holds\","), 0U);
  EXPECT_THAT(csv, HasSubstr("\"0.1 of \"\"1\"\", <fine>\"\nbad,First,FAILS,0.00,"));
}

}  // namespace stability_report_test
