#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/bench/feature_study.hpp"

namespace feature_report_test {

using namespace app::bench;
using testing::HasSubstr;

const std::vector<FeatureCost>& costs() {
  static const std::vector<FeatureCost> all{
      {"shear test", "small strain", "nothing can fail in shear", 1.25e-9, 1.5e-9, 3e-12, true, 1e-9},
      {"damping", "moving points", "nothing is damped", 12e-9, 15e-9, 0.02, true, 1e-9},
      {"closure", "moving points", "nothing can crack", 12e-9, 15e-9, 0, false, 1e-9}};
  return all;
}

TEST(FeatureReport, GivesTimesAndAgreement) {
  EXPECT_THAT(feature_text(costs()),
              HasSubstr("shear test               small strain       1.25     1.50    +0.25   to 3"));
  const std::string html = feature_html(costs());
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">shear test, small strain</th><td>nothing can fail in "
                              "shear</td><td>1.25</td><td>1.50</td><td>20.0\u00A0%</td>"));
  EXPECT_THAT(feature_csv(costs()),
              HasSubstr("shear test,small strain,nothing can fail in shear,1.25e-09,1.5e-09,3e-12,1,1\n"));
}

TEST(FeatureReport, HidesNoDisagreement) {
  EXPECT_THAT(feature_text(costs()), HasSubstr("NO: off by 0.02"));
  EXPECT_THAT(feature_text(costs()), HasSubstr("NO: other points fail"));
  EXPECT_THAT(feature_html(costs()), HasSubstr("NO: other points fail"));
  EXPECT_THAT(feature_csv(costs()), HasSubstr(",0.02,1,0\n"));
  EXPECT_THAT(feature_csv(costs()), HasSubstr(",0,0,0\n"));
}

}  // namespace feature_report_test
