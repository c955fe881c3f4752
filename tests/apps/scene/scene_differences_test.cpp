#include "apps/scene/scene_text.hpp"

#include <gtest/gtest.h>

#include "apps/text/complaint.hpp"

namespace scene_differences_test {

using app::scene_differences;

TEST(SceneDifferences, AreTheSettingsThatAreNotAllTheSame) {
  const auto found =
      scene_differences({"[loading]\nvelocity = 0.1\ndirection = \"tension\"\n[solver]\ncfl = 0.5\n",
                         "[loading]\nvelocity = 0.2\ndirection = \"tension\"\n[solver]\ncfl = 0.5\n",
                         "[loading]\nvelocity = 0.1\ndirection = \"tension\"\nextra = [1, 2]\n"});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].key, "loading.extra");
  EXPECT_EQ(found[0].values, (std::vector<std::string>{"", "", "[1, 2]"}));
  EXPECT_EQ(found[1].key, "loading.velocity");
  EXPECT_EQ(found[1].values, (std::vector<std::string>{"0.1", "0.2", "0.1"}));
  EXPECT_EQ(found[2].key, "solver.cfl");
  EXPECT_EQ(found[2].values.back(), "");
}

TEST(SceneDifferences, OfTheSameScenesAreNone) {
  EXPECT_TRUE(scene_differences({"[a]\nb = 1\n", "[a]\nb = 1\n"}).empty());
}

TEST(SceneDifferences, RefusesWhatIsNoScene) {
  EXPECT_THROW((void)scene_differences({"[a", "[a]"}), app::Rejected);
  std::string deep = "a = ";
  for (int i = 0; i < 100'000; ++i) deep += '[';
  EXPECT_THROW((void)scene_differences({deep, "[a]"}), app::Rejected)
      << "a parser that calls itself would crash";
}

}  // namespace scene_differences_test
