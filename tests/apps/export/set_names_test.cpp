#include "apps/export/mesh_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace set_names_test {

using exchange::group_names;
using exchange::set_names;
using testing::ElementsAre;

TEST(SetNames, AreCapitalsDigitsAndUnderscores) {
  EXPECT_THAT(set_names({"aggregate", "itz", "fly ash-2", "2nd", "", "zäh"}),
              ElementsAre("AGGREGATE", "ITZ", "FLY_ASH_2", "PHASE_2ND", "PHASE_", "Z__H"));
}

TEST(SetNames, DifferEvenWhereThePhasesDifferOnlyByCase) {
  EXPECT_THAT(set_names({"steel", "Steel", "STEEL", "steel_2"}),
              ElementsAre("STEEL", "STEEL_2", "STEEL_3", "STEEL_2_2"));
}

TEST(SetNames, HaveAtMostEightyCharactersAndStillDiffer) {
  const std::vector<std::string> names = set_names({std::string(90, 'a'), std::string(91, 'a')});
  EXPECT_THAT(names, ElementsAre(std::string(80, 'A'), std::string(78, 'A') + "_2"));
}

TEST(GroupNames, KeepAllButQuotesAndLineBreaks) {
  EXPECT_THAT(group_names({"fly ash-2", "zäh", "a\"b", "a\nb"}),
              ElementsAre("fly ash-2", "zäh", "a_b", "a_b_2"));
}

TEST(GroupNames, AreNotCutWithinACharacter) {
  const std::string name = group_names({std::string(119, 'a') + "ä"}).front();
  EXPECT_EQ(name, std::string(119, 'a'));
}

}  // namespace set_names_test
