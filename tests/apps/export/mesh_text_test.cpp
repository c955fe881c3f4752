#include "apps/export/mesh_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "tests/specimen/temporary_folder.hpp"

namespace mesh_text_test {

using exchange::group_names;
using exchange::set_names;
using testing::ElementsAre;

TEST(TextStream, HandsOnLargePiecesInOrder) {
  std::string received;
  std::size_t largest = 0;
  int pieces = 0;
  const specimen::ByteSink sink = [&](std::span<const std::byte> bytes) {
    received.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    largest = std::max(largest, bytes.size());
    ++pieces;
  };
  exchange::TextStream stream(sink);
  std::string expected;
  for (std::int64_t i = 0; i < 400'000; ++i) {
    stream << i << ", ";
    expected += std::to_string(i) + ", ";
  }
  EXPECT_LT(received.size(), expected.size()) << "the last piece is kept until the end";
  stream.flush();
  EXPECT_TRUE(received == expected);
  EXPECT_GT(pieces, 2);
  EXPECT_LT(pieces, 10);
  EXPECT_LT(largest, std::size_t{1} << 21) << "memory is bounded";
}

TEST(TextStream, WritesAFile) {
  const test::TemporaryFolder folder;
  exchange::write_text(folder / "a", [](exchange::TextStream& file) { file << "x " << -12 << "\n"; });
  EXPECT_EQ(test::read_text(folder / "a"), "x -12\n");
}

TEST(LengthText, FitsWhereTwentyCharactersAreAllowed) {
  EXPECT_EQ(exchange::length_text(3 * 0.1e-3), "0.0003") << "no noise of the last digit";
  EXPECT_EQ(exchange::length_text(0), "0");
  for (const double length : {1.0 / 3, 1e-3 / 3, 1e-4 / 3, 1e-5 / 3, 1e5 / 3})
    EXPECT_LE(exchange::length_text(length).size(), 20U);
}

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

}  // namespace mesh_text_test
