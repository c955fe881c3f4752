#include "apps/reproduce/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/reproduce/tiny_effort.hpp"

namespace reproduce_report_test {

using namespace app::reproduce;
using testing::HasSubstr;
using testing::Not;

/// All figures on tiny specimens, run once for all tests.
const Reproduction& everything() {
  static const Reproduction reproduction = reproduce_figures(
      select_figures({}), test::tiny_effort(), 2, {[](std::size_t, std::size_t) {}, [] { return true; }});
  return reproduction;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

TEST(ReproduceReport, HoldsEveryFigure) {
  const std::string html = report_html(everything());
  for (const Figure& figure : figures())
    EXPECT_THAT(html, HasSubstr("<h2>" + name_of(figure) + ". " + figure.title + "</h2>"));
}

TEST(ReproduceReport, HoldsEveryClaimAndItsVerdict) {
  const std::string html = report_html(everything());
  const std::vector<Claim> claims = claims_of(everything());
  EXPECT_EQ(claims.size(), 11U);
  EXPECT_EQ(count(html, "<td class=\"verdict "), claims.size());
  for (const Claim& claim : claims) {
    EXPECT_FALSE(claim.measured.empty()) << claim.id;
    EXPECT_FALSE(claim.why.empty()) << claim.id;
  }
}

TEST(ReproduceReport, AsksForNothingOutsideItself) {
  const std::string html = report_html(everything());
  for (const char* part : {"href=", "src=\"http", "<script", "url("}) EXPECT_THAT(html, Not(HasSubstr(part)));
}

TEST(ReproduceReport, LeavesOutAndNamesWhatWasNotDone) {
  const std::string html =
      report_html(reproduce_figures(select_figures({"12", "1"}), test::tiny_effort(), 1,
                                    {[](std::size_t, std::size_t) {}, [] { return false; }}));
  EXPECT_THAT(html, HasSubstr("It was interrupted before the runs of these were done: Figure 12."));
  EXPECT_THAT(html, Not(HasSubstr("<h2>Figure 12.")));
  EXPECT_THAT(html, HasSubstr("<h2>Figures 1 and 2."));
}

TEST(ReproduceReport, JsonHoldsClaimsFiguresAndRuns) {
  const nlohmann::json json = report_json(everything());
  EXPECT_EQ(json["claims"].size(), 11U);
  EXPECT_EQ(json["figures"].size(), figures().size());
  EXPECT_EQ(json["runs"].size(), everything().outcomes.entries().size());
  EXPECT_THAT(json["runs"][0]["command"].get<std::string>(), HasSubstr("mesopix simulate data/paper/"));
  EXPECT_EQ(json["interrupted"], false);
}

TEST(ReproduceReport, CountsTheVerdicts) {
  const auto claim = [](Verdict verdict) {
    Claim one;
    one.verdict = verdict;
    return one;
  };
  EXPECT_EQ(verdict_counts({claim(Verdict::agrees), claim(Verdict::agrees), claim(Verdict::depends)}),
            "2 agree with this run and 1 depends on a choice or on chance");
  EXPECT_EQ(verdict_counts({claim(Verdict::disagrees)}), "1 disagrees");
}

TEST(ReproduceReport, HasNoHeadingForClaimsThatThereAreNot) {
  const Reproduction reproduction = reproduce_figures(select_figures({"objectivity"}), test::tiny_effort(), 1,
                                                      {[](std::size_t, std::size_t) {}, [] { return true; }});
  ASSERT_TRUE(claims_of(reproduction).empty());
  EXPECT_THAT(report_html(reproduction), Not(HasSubstr("<h2>Claims</h2>")));
  EXPECT_THAT(report_html(reproduction), HasSubstr("<h2>How it was run</h2>"));
  EXPECT_THAT(report_html(everything()), HasSubstr("<h2>Claims</h2>"));
}

}  // namespace reproduce_report_test
