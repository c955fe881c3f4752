#include "apps/manual/setting_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace setting_words_test {

using manual::SettingWords;
using testing::HasSubstr;

SettingWords words_of(const std::string& key) {
  for (const manual::TableWords& table : manual::scene_tables())
    for (const SettingWords& setting : table.settings)
      if (table.name + "." + setting.key == key) return setting;
  throw std::invalid_argument("no setting " + key);
}

TEST(SettingWords, HoldEverySettingOnce) {
  std::size_t count = 0;
  for (const manual::TableWords& table : manual::scene_tables()) count += table.settings.size();
  EXPECT_EQ(count, app::fields().size() + app::phase_fields().size());
  EXPECT_EQ(manual::scene_tables().size(), app::groups().size());
}

TEST(SettingWords, SayWhatIsAllowed) {
  EXPECT_EQ(words_of("loading.velocity").allowed, "> 0");
  EXPECT_EQ(words_of("loading.velocity").default_value, "\"0.05 m/s\"");
  EXPECT_EQ(words_of("loading.initial_velocity_x").allowed, "any");
  EXPECT_EQ(words_of("generate.fraction").allowed, "in [0, 1)");
  EXPECT_EQ(words_of("convert.classes").allowed, "in [2, 16], or \"auto\"");
  EXPECT_EQ(words_of("solver.threads").allowed, "in [1, 1024], or \"auto\"");
  EXPECT_EQ(words_of("loading.stop_drop").allowed, "in (0, 1), or \"none\"");
  EXPECT_EQ(words_of("damage.seed").allowed, ">= 0");
  EXPECT_EQ(words_of("loading.platen").allowed, "");
  EXPECT_EQ(words_of("loading.separation").type, "true|false");
  EXPECT_EQ(words_of("specimen.file").default_value, "");
}

TEST(SettingWords, SayTheDefaultOfEveryPhase) {
  EXPECT_EQ(words_of("phases.NAME.young").default_value,
            "\"40 GPa\" (aggregate), \"20 GPa\" (mortar), \"12 GPa\" (itz)");
  EXPECT_EQ(words_of("phases.NAME.poisson").default_value, "0.2");
}

TEST(SettingWords, NameTheUnitsOfEveryType) {
  const std::vector<manual::TypeWords> types = manual::quantity_types();
  EXPECT_EQ(types.size(), 9u);
  EXPECT_EQ(types[1].name, "LENGTH");
  EXPECT_THAT(types[1].units, HasSubstr("mm, m, um, cm or "));
  EXPECT_EQ(types[1].example, "0.5 mm");
}

TEST(SettingWords, NameTheKeysOfAnEllipse) {
  EXPECT_THAT(manual::about_ellipses(), HasSubstr("[[ellipses]] with x, y, a and b, and with angle where"));
}

}  // namespace setting_words_test
