#include "specimen/convert/tones.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/specimen/drawn.hpp"
#include "tests/specimen/known_truth.hpp"

namespace tones_test {

using specimen::Picture;
using specimen::Raster;
using specimen::Rgb;
using specimen::sort_into_tones;
using specimen_test::drawn_softly;
using specimen_test::known_truth;
using specimen_test::KnownTruth;
using specimen_test::picture_of;

/// Share of pixels whose tone is not that of the truth.
double share_wrong(const specimen::ValueMap& map, const KnownTruth& truth,
                   const std::array<std::int64_t, 3>& tones) {
  double wrong = 0;
  for (std::size_t i = 0; i < map.code.size(); ++i)
    wrong += map.values[static_cast<std::size_t>(map.code.data[i])] != tones[truth.labels.data[i]];
  return wrong / static_cast<double>(map.code.size());
}

TEST(Tones, SoftEdgesGoToTheNearerSide) {
  const KnownTruth truth = known_truth();
  const auto two = sort_into_tones(picture_of(drawn_softly(truth, {0, 255, 0})));
  ASSERT_TRUE(two);
  EXPECT_EQ(two->map.values, (std::vector<std::int64_t>{0, 255}));
  EXPECT_GT(two->settled, 500);
  EXPECT_LT(share_wrong(two->map, truth, {0, 255, 0}), 0.02);
}

// The edge between 0 and 255 passes through 128, which is the matrix elsewhere.
TEST(Tones, AnEdgeIsNoThirdTone) {
  const KnownTruth truth = known_truth();
  for (const std::array<double, 3>& codes :
       {std::array{128.0, 0.0, 255.0}, std::array{0.0, 255.0, 128.0}, std::array{60.0, 200.0, 120.0}}) {
    const auto three = sort_into_tones(picture_of(drawn_softly(truth, codes)));
    ASSERT_TRUE(three);
    EXPECT_EQ(three->map.count(), 3);
    const std::array<std::int64_t, 3> tones{std::int64_t(codes[0]), std::int64_t(codes[1]),
                                            std::int64_t(codes[2])};
    EXPECT_LT(share_wrong(three->map, truth, tones), 0.02) << codes[0];
  }
}

// Two stones one pixel apart, in a picture at half its size: the gap is half as bright in two pixels, or in
// one.
TEST(Tones, TheTraceOfAGapKeepsStonesApart) {
  for (const bool wide : {false, true})
    for (const std::array<double, 2>& tones : {std::array{0.0, 255.0}, std::array{200.0, 40.0}}) {
      Raster<double> gray(40, 50, tones[0]);
      for (int r = 5; r < 30; ++r)
        for (int c = 5; c < 40; ++c) {
          const bool gap = c == 20 || (wide && c == 21);
          gray(r, c) = gap ? std::floor(0.45 * tones[0] + 0.55 * tones[1]) : tones[1];
        }
      const auto toned = sort_into_tones(picture_of(gray));
      ASSERT_TRUE(toned);
      for (int r = 5; r < 30; ++r)
        EXPECT_EQ(toned->map.values[static_cast<std::size_t>(toned->map.code(r, 20))], tones[0]) << r;
    }
}

TEST(Tones, ColoursAsWell) {
  const KnownTruth truth = known_truth();
  const Raster<double> red = drawn_softly(truth, {0, 255, 20}), blue = drawn_softly(truth, {0, 10, 240});
  Picture picture;
  picture.colour = Raster<Rgb>(truth.rows, truth.cols);
  for (std::size_t i = 0; i < red.size(); ++i)
    picture.colour.data[i] = {static_cast<std::uint8_t>(red.data[i]), 0,
                              static_cast<std::uint8_t>(blue.data[i])};
  const auto toned = sort_into_tones(picture);
  ASSERT_TRUE(toned);
  EXPECT_TRUE(toned->map.colours);
  EXPECT_LT(share_wrong(toned->map, truth, {0, 0xff000a, 0x1400f0}), 0.02);
}

TEST(Tones, FractionsOfADeepPictureAsWell) {
  const KnownTruth truth = known_truth();
  Raster<double> gray = drawn_softly(truth, {0, 200, 100});
  for (double& v : gray.data) v /= 200;
  const auto toned = sort_into_tones(picture_of(gray));
  ASSERT_TRUE(toned);
  EXPECT_EQ(toned->map.count(), 3);
}

TEST(Tones, APhotographHasNone) {
  Raster<double> noise(80, 80);
  std::mt19937_64 random(3);
  for (double& v : noise.data) v = static_cast<double>(random() % 256);
  EXPECT_FALSE(sort_into_tones(picture_of(noise)));
  EXPECT_FALSE(sort_into_tones(picture_of(Raster<double>(40, 40, 7.0))));
}

}  // namespace tones_test
