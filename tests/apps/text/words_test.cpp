#include "apps/text/words.hpp"

#include <gtest/gtest.h>

namespace words_test {

TEST(Lower, ChangesTheLettersOfEnglishAlone) { EXPECT_EQ(app::lower("PNG \u00c4 2a"), "png \u00c4 2a"); }

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(app::edit_distance("velocity", "velocity"), 0);
  EXPECT_EQ(app::edit_distance("velocty", "velocity"), 1);
  EXPECT_EQ(app::edit_distance("velocityy", "velocity"), 1);
  EXPECT_EQ(app::edit_distance("velozity", "velocity"), 1);
  EXPECT_EQ(app::edit_distance("veloctiy", "velocity"), 1);  // two neighbours swapped
  EXPECT_EQ(app::edit_distance("kitten", "sitting"), 3);     // the textbook's pair
  EXPECT_EQ(app::edit_distance("", "abc"), 3);
}

TEST(EditDistance, IsSymmetric) {
  for (const auto& [a, b] : {std::pair("young", "yung"), std::pair("cfl", "clf"), std::pair("", "x")})
    EXPECT_EQ(app::edit_distance(a, b), app::edit_distance(b, a));
}

TEST(Closest, IgnoresCaseAndRefusesWhatIsFar) {
  const std::vector<std::string> names{"tension", "compression"};
  EXPECT_EQ(app::closest("Tensoin", names), "tension");
  EXPECT_EQ(app::closest("bending", names), "");
  EXPECT_EQ(app::did_you_mean("compresion", names), "did you mean compression?");
  EXPECT_EQ(app::did_you_mean("bending", names), "");
  EXPECT_EQ(app::did_you_mean("x", {}), "");
}

TEST(Listed, ReadsAsASentence) {
  EXPECT_EQ(app::listed({"a"}), "a");
  EXPECT_EQ(app::listed({"a", "b"}), "a or b");
  EXPECT_EQ(app::listed({"a", "b", "c"}, "and"), "a, b and c");
}

TEST(Counted, HasThePluralForAllButOne) {
  EXPECT_EQ(app::counted(0, "aggregate"), "0 aggregates");
  EXPECT_EQ(app::counted(1, "aggregate"), "1 aggregate");
  EXPECT_EQ(app::counted(151, "aggregate"), "151 aggregates");
  EXPECT_EQ(app::counted(2, "class"), "2 classes");
}

}  // namespace words_test
