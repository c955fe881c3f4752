#include "apps/report/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/fake_run.hpp"

namespace comparison_test {

using output::comparison_html;
using testing::HasSubstr;
using testing::Not;

std::vector<output::ComparedRun> two_runs() {
  std::vector<output::ComparedRun> runs{{"one", tension_run(30).result}, {"two", tension_run(30).result}};
  runs[1].result.peak_stress *= 1.25;
  return runs;
}

TEST(Comparison, ShowsFiguresWithTheirDistanceFromTheFirst) {
  const std::string page = comparison_html(two_runs(), {});
  EXPECT_THAT(page, HasSubstr("Peak stress [MPa]</th><td>3.43</td><td>4.29 (+25.0\u00A0%)</td>"));
  EXPECT_THAT(page, HasSubstr("(same)"));
  EXPECT_THAT(page, HasSubstr("The scenes are identical."));
}

TEST(Comparison, TellsNoDistanceFromAPeakOfWhatIsNone) {
  auto runs = two_runs();
  std::erase_if(runs[1].result.history, [](const mpm::HistoryRow& row) { return row.strain > 144e-6; });
  EXPECT_THAT(comparison_html(runs, {}),
              HasSubstr("Peak stress [MPa]</th><td>3.43</td><td>4.29, no peak</td>"));
  std::swap(runs[0], runs[1]);
  EXPECT_THAT(comparison_html(runs, {}),
              HasSubstr("Peak stress [MPa]</th><td>4.29, no peak</td><td>3.43</td>"));
}

TEST(Comparison, ShowsSettingsThatDiffer) {
  const std::string page = comparison_html(two_runs(), {{"damage.seed", {"1", ""}}});
  EXPECT_THAT(page, HasSubstr("damage.seed</th><td>1</td><td>–</td>"));
  EXPECT_THAT(page, Not(HasSubstr("The scenes are identical.")));
}

TEST(Comparison, EscapesNamesAndSettings) {
  auto runs = two_runs();
  const std::string evil = "</script><script>alert(1)</script>";
  runs[0].name = evil;
  const std::string page = comparison_html(runs, {{evil, {evil, evil}}});
  EXPECT_THAT(page, Not(HasSubstr(evil)));
  EXPECT_THAT(page, HasSubstr("\\u003c/script\\u003e"));
}

}  // namespace comparison_test
