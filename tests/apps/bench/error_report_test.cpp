#include "apps/bench/error_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace error_report_test {

using namespace app::bench;
using testing::HasSubstr;
using testing::Not;

const std::vector<ProblemResult>& results() {
  static const std::vector<ProblemResult> all = [] {
    const auto gives = [](double error, double time, const char* trouble = "") -> Run {
      return [=] { return Measured{error, time, 4096, trouble}; };
    };
    Problem bar{"bar", "A bar < a beam", "distance from the solution", "v = v0", "It lags.", {}, {}};
    bar.methods = {{"GIMP", "cell", "", {0.25, 0.125}, {gives(0.02, 0.5), gives(0.005, 2)}},
                   {"linear", "cell", "", {0.25, 0.125}, {gives(0.04, 0.6), gives(0, 1, "it left")}}};
    Problem pull{"pull", "A test", "error of the peak", "a slow run", "Slow is right.", gives(2, 9), {}};
    pull.methods = {{"lattice", "velocity", "m/s", {0.1}, {gives(2.4, 1)}}};
    return study_errors({bar, pull}, {});
  }();
  return all;
}

TEST(ErrorReport, HasAChartATableAndAWordOnEachProblem) {
  const std::string html = error_html(results());
  for (const char* part : {"<h2>A bar &lt; a beam</h2>", "Distance from the solution. Right answer: v = v0.",
                           "<h2>A test</h2>", "Right answer: a slow run; it took 9.00 s.", "It lags.",
                           "cell 1/4 … 1/8", "velocity 0.1 m/s", "<td>none</td>", "20 %"})
    EXPECT_THAT(html, HasSubstr(part));
  EXPECT_EQ(std::count(html.begin(), html.end(), '\0'), 0);
}

TEST(ErrorReport, DrawsErrorsAgainstTimeAndAgainstPointUpdates) {
  const std::string html = error_html(results());
  for (const char* title : {"Error against wall time: A test", "Error against point-updates: A test"})
    EXPECT_THAT(html, HasSubstr(title));
  EXPECT_THAT(html, HasSubstr("Wall time (s)"));
  EXPECT_THAT(html, HasSubstr(">Point-updates<"));
}

TEST(ErrorReport, ShowsTheCheapestWaysAndHowNearOthersCame) {
  const std::string html = error_html(results());
  EXPECT_THAT(html, HasSubstr("<td>GIMP, cell 1/4: 500 ms</td><td>GIMP, cell 1/8: 2.00 s</td>"
                              "<td>none; the best is 0.50 %</td>"));
  EXPECT_THAT(error_text(results()), HasSubstr("pull              5 %   none; the best is 20 %\n"));
}

TEST(ErrorReport, HidesNoRunThatStopped) {
  const std::string html = error_html(results());
  EXPECT_THAT(html, HasSubstr("4.0 %  →  stopped"));
  EXPECT_THAT(html, HasSubstr("linear, cell 1/8, stopped: it left."));
}

TEST(ErrorReport, AsksForNothingOutsideItself) {
  for (const char* part : {"href=", "src=\"http", "<script", "url("})
    EXPECT_THAT(error_html(results()), Not(HasSubstr(part)));
}

TEST(ErrorReport, TableHasALineARun) {
  const std::string csv = error_csv(results());
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
  EXPECT_THAT(csv, HasSubstr("problem,method,refined,size,unit,error,wall_time_s,point_updates,order,front,"
                             "trouble\nbar,\"GIMP\",cell,0.25,,0.02,0.5,4096,nan,1,\"\"\n"));
  EXPECT_THAT(csv, HasSubstr("bar,\"linear\",cell,0.125,,nan,1,4096,nan,0,\"it left\"\n"));
  EXPECT_THAT(csv, HasSubstr("pull,\"lattice\",velocity,0.1,m/s,0.19999999999999996,1,4096,nan,1,\"\"\n"));
}

}  // namespace error_report_test
