#include "apps/scene/test_scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"

namespace test_scenes_test {

/// All that is wrong with a scene, a text each.
std::vector<std::string> complaints_about(const std::string& toml) {
  std::vector<std::string> lines;
  try {
    (void)app::resolve(app::parse_scene(toml, "dir/scene.toml"), {});
  } catch (const app::Rejected& rejected) {
    for (const app::Complaint& complaint : rejected.complaints) lines.push_back(text(complaint));
  }
  return lines;
}

TEST(TestScenes, EachIsASceneThatReadsBack) {
  for (const app::TestScene& test : app::test_scenes()) {
    app::DraftWish wish;
    wish.test = test.name;
    wish.file = "scene.toml";
    const std::string draft = app::scene_draft(wish);
    EXPECT_THAT(complaints_about(draft), testing::IsEmpty()) << test.name;
    const app::Settings settings = app::resolve(app::parse_scene(draft, "scene.toml"), {}).settings;
    EXPECT_EQ(settings.title, test.title);
    EXPECT_TRUE(settings.scene.fixture.has_loads());
    EXPECT_NE(settings.scene.fixture.leading(), nullptr);
    // What a run keeps is the same scene.
    const std::string kept = app::scene_text(settings, app::Extent::whole, ".");
    const app::Settings again = app::resolve(app::parse_scene(kept, "scene.toml"), {}).settings;
    EXPECT_EQ(app::scene_text(again, app::Extent::whole, "."), kept) << test.name;
  }
}

TEST(TestScenes, ListsOfTablesAreReadWithTheirPlaces) {
  const std::vector<std::string> lines = complaints_about(
      "[[supports]]\n"
      "at = \"botom\"\n"
      "fix = \"y\"\n"
      "[[supports]]\n"
      "frm = \"1 mm\"\n"
      "at = \"bottom\"\n"
      "[[loads]]\n"
      "at = \"top\"\n"
      "displacement = \"down\"\n"
      "from = 3\n");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_THAT(lines[1], testing::StartsWith("dir/scene.toml:4:1: supports[2]: fix is missing"));
  EXPECT_THAT(lines[0],
              testing::HasSubstr("2:6: supports[1].at: \"botom\"; must be bottom, top, left or right"));
  EXPECT_THAT(lines[2],
              testing::HasSubstr("5:1: supports[2].frm: unknown key; did you mean supports[2].from"));
  EXPECT_THAT(lines[3], testing::HasSubstr("10:8: loads[1].from: 3;"));
}

TEST(TestScenes, WhatIsNoListOfTablesIsRefused) {
  EXPECT_THAT(complaints_about("loads = 3\n"),
              testing::ElementsAre(testing::HasSubstr("loads: not a list of tables; write [[loads]]")));
}

TEST(TestScenes, BesideLoadsPlatensHaveNoSettings) {
  const std::string loads = "[[loads]]\nat = \"top\"\ndisplacement = \"up\"\n";
  EXPECT_THAT(
      complaints_about("[loading]\nplaten = \"rough\"\n" + loads),
      testing::ElementsAre(testing::HasSubstr("loading.platen: \"rough\"; has no effect beside [[loads]]")));
}

TEST(TestScenes, NumbersOfItemsAreKeysOfStudiesToo) {
  EXPECT_TRUE(app::find_field("loads[1].from").has_value());
  for (const char* key : {"loads[0].from", "loads[1].form", "loads[x].from", "loads[].from",
                          "loads[1001].from", "loads.from", "loads[1]from"})
    EXPECT_FALSE(app::find_field(key).has_value()) << key;
}

}  // namespace test_scenes_test
