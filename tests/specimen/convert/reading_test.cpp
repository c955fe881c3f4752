#include "specimen/convert/reading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/specimen/drawn.hpp"
#include "tests/specimen/known_truth.hpp"

namespace reading_test {

using specimen::Raster;
using specimen::read_map;
using specimen::Reading;
using specimen_test::coded;
using specimen_test::draw_disc;
using specimen_test::known_truth;
using specimen_test::picture_of;
using Names = std::vector<std::string>;

Reading reading_of(const Raster<double>& gray) { return read_map(*distinct_values(picture_of(gray), 256)); }

/// Void, aggregate and mortar in these numbers are read as such, without a doubt.
void expect_read(const std::array<double, 3>& codes) {
  const Reading reading = reading_of(coded(known_truth().labels, codes));
  std::vector<std::pair<double, std::string>> wanted{
      {codes[0], "void"}, {codes[1], "aggregate"}, {codes[2], "mortar"}};
  std::sort(wanted.begin(), wanted.end());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(reading.phases[i], wanted[i].second) << codes[0] << " " << codes[1] << " " << codes[2];
  EXPECT_TRUE(reading.other.empty()) << reading.doubt;
}

TEST(Reading, NumbersOfThreePhasesMayBeAnyNumbers) {
  for (const std::array<double, 3>& codes : std::vector<std::array<double, 3>>{{0, 1, 2},
                                                                               {0, 2, 1},
                                                                               {1, 2, 3},
                                                                               {1, 3, 2},
                                                                               {2, 1, 0},
                                                                               {2, 3, 1},
                                                                               {0, 255, 128},
                                                                               {0, 128, 255},
                                                                               {255, 128, 0}})
    expect_read(codes);
}

TEST(Reading, TwoPhasesAreStonesInAMatrixWhateverTheyAreCalled) {
  for (const auto& [stone, matrix] :
       {std::pair(1.0, 0.0), {0.0, 1.0}, {255.0, 0.0}, {0.0, 255.0}, {2.0, 0.0}, {0.0, 3.0}}) {
    const Reading reading = reading_of(coded(known_truth().labels, std::array{matrix, stone, matrix}));
    const bool stone_first = stone < matrix;
    EXPECT_EQ(reading.phases, stone_first ? (Names{"aggregate", "mortar"}) : (Names{"mortar", "aggregate"}));
    EXPECT_TRUE(reading.other.empty());
  }
}

TEST(Reading, ABandThatKeepsStonesAndMatrixApartIsItz) {
  Raster<std::uint8_t> labels = known_truth().labels;
  const Raster<std::uint8_t> before = labels;
  for (int r = 0; r < labels.rows; ++r)
    for (int c = 0; c < labels.cols; ++c)
      if (before(r, c) == 2)
        for (const auto& [dr, dc] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
          if (before.contains(r + dr, c + dc) && before(r + dr, c + dc) == 1) labels(r, c) = 3;
  EXPECT_EQ(reading_of(coded(labels, std::array{0.0, 1.0, 2.0, 3.0})).phases,
            (Names{"void", "aggregate", "mortar", "itz"}));
  EXPECT_EQ(reading_of(coded(labels, std::array{3.0, 2.0, 0.0, 1.0})).phases,
            (Names{"mortar", "itz", "aggregate", "void"}));
}

TEST(Reading, OfTwoThatMayBothBeTheMatrixNoneIsChosen) {
  Raster<double> halves(60, 80, 1.0);
  for (int r = 0; r < 60; ++r)
    for (int c = 0; c < 40; ++c) halves(r, c) = 7;
  const Reading reading = reading_of(halves);
  EXPECT_EQ(reading.doubt, "which value is the mortar");
  EXPECT_NE(reading.phases, reading.other);
}

TEST(Reading, DotsAloneMayBePoresOrSand) {
  Raster<double> dots(200, 200, 1.0);
  for (int i = 0; i < 5; ++i) draw_disc(dots, 30.0 + 30 * i, 40.0 + 20 * i, 2.5, 0.0);
  const Reading reading = reading_of(dots);
  EXPECT_EQ(reading.phases, (Names{"aggregate", "mortar"}));
  EXPECT_EQ(reading.other, (Names{"void", "mortar"}));
}

TEST(Reading, ASecondKindOfStonesIsNoVoid) {
  Raster<double> two_kinds(120, 200, 1.0);
  for (int i = 0; i < 4; ++i) {
    draw_disc(two_kinds, 30, 25.0 + 50 * i, 18, 2.0);
    draw_disc(two_kinds, 90, 25.0 + 50 * i, 15, 3.0);
  }
  const Reading reading = reading_of(two_kinds);
  EXPECT_EQ(reading.phases, (Names{"mortar", "aggregate", "aggregate"}));
  EXPECT_TRUE(reading.other.empty());
}

TEST(Reading, TheRefusalOffersBothAsOptions) {
  const specimen::ValueMap map =
      *distinct_values(picture_of(coded(known_truth().labels, std::array{0.0, 1.0, 2.0})), 9);
  const Reading reading{{"void", "aggregate", "mortar"}, {"aggregate", "aggregate", "mortar"}, "what 0 is"};
  const specimen::TwoReadings refusal = refusal_of(map, reading);
  EXPECT_EQ(refusal.label_phases, (Names{"0:void,1:aggregate,2:mortar", "0:aggregate,1:aggregate,2:mortar"}));
  EXPECT_THAT(refusal.what(), ::testing::HasSubstr("it is not clear what 0 is"));
}

}  // namespace reading_test
