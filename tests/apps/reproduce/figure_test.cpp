#include "apps/reproduce/figure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "apps/reproduce/campaign.hpp"
#include "apps/text/complaint.hpp"

namespace figure_test {

using namespace app::reproduce;
using testing::ElementsAre;

TEST(Claim, AgreesWhereItHoldsInAllCases) {
  EXPECT_EQ(verdict_of({true, true}), Verdict::agrees);
  EXPECT_EQ(verdict_of({true, false}), Verdict::depends);
  EXPECT_EQ(verdict_of({false, false}), Verdict::disagrees);
}

TEST(Claim, AboutChanceAgreesWhereItHoldsMostly) {
  EXPECT_EQ(verdict_of_share(0.8), Verdict::agrees);
  EXPECT_EQ(verdict_of_share(0.79), Verdict::depends);
  EXPECT_EQ(verdict_of_share(0.21), Verdict::depends);
  EXPECT_EQ(verdict_of_share(0.2), Verdict::disagrees);
}

TEST(Claim, HasAWordForEachVerdict) {
  EXPECT_EQ(word_of(Verdict::agrees), "agrees");
  EXPECT_EQ(word_of(Verdict::disagrees), "disagrees");
  EXPECT_EQ(word_of(Verdict::depends), "depends");
}

std::vector<std::string> names(const std::vector<const Figure*>& figures) {
  std::vector<std::string> names;
  for (const Figure* figure : figures) names.push_back(name_of(*figure));
  return names;
}

TEST(FigureTable, NoIdMeansAll) {
  EXPECT_THAT(names(select_figures({})),
              ElementsAre("Figures 1 and 2", "Figure 3", "Figure 5", "Figures 6 and 7", "Figures 8 to 11",
                          "Figure 12", "Figure 13", "Figure 14", "Objectivity", "Inertia"));
}

TEST(FigureTable, SelectsEachFigureOnceInTheOrderOfThePaper) {
  EXPECT_THAT(names(select_figures({"12", "9", "3", "8", "12"})),
              ElementsAre("Figure 3", "Figures 8 to 11", "Figure 12"));
}

TEST(FigureTable, RefusesAnUnknownFigure) {
  try {
    static_cast<void>(select_figures({"3", "4"}));
    FAIL() << "no error";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::usage);
    EXPECT_EQ(app::text(rejected.complaints.front()),
              "--figure: 4; must be 1, 2, 3, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, objectivity or inertia; "
              "leave it out, "
              "or give --all, for "
              "all of them");
  }
}

TEST(FigureTable, NoIdOccursTwice) {
  std::set<std::string> ids;
  for (const Figure& figure : figures())
    for (const std::string& id : figure.ids) EXPECT_TRUE(ids.insert(id).second) << id;
}

}  // namespace figure_test
