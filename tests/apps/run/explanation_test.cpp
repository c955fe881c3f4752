#include "apps/run/run_remarks.hpp"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace explanation_test {

using testing::HasSubstr;

mpm::Explanation some_explanation() {
  mpm::Explanation explanation;
  explanation.kinematics = "small strain";
  explanation.bytes = 21;
  explanation.time = 2e-9;
  explanation.features = {{"tension test", true, "a phase can fail", 4, std::nullopt},
                          {"crack closure", false, "damage.crack_closure is off", 4, 1.5e-9},
                          {"local damping", false, "solver.local_damping is 0", 0, -1e-12}};
  return explanation;
}

TEST(Explanation, TellsWhatIsInAndWhatIsLeftOutWithItsPrice) {
  const std::string text = app::explanation_text(some_explanation());
  EXPECT_THAT(text, HasSubstr("small strain: 21 bytes a point, 2.00 ns a point and step"));
  EXPECT_LT(text.find("tension test"), text.find("Left out"));
  EXPECT_GT(text.find("crack closure"), text.find("Left out"));
  EXPECT_THAT(text, HasSubstr("1.50  damage.crack_closure is off"));
}

TEST(Explanation, DoesNotShowNoiseAsAFigure) {
  EXPECT_THAT(app::explanation_text(some_explanation()), HasSubstr("< 0.10  solver.local_damping is 0"));
}

TEST(Explanation, IsCompleteAsJson) {
  const nlohmann::ordered_json json = app::explanation_json(some_explanation());
  EXPECT_EQ(json["bytes_per_point"], 21);
  ASSERT_EQ(json["features"].size(), 3U);
  EXPECT_EQ(json["features"][1]["s_per_point_update"], 1.5e-9);
  EXPECT_EQ(json["features"][0]["in"], true);
  EXPECT_FALSE(json["features"][0].contains("s_per_point_update")) << "not measured";
}

}  // namespace explanation_test
