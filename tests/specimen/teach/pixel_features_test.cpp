#include "specimen/teach/pixel_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/specimen/drawn.hpp"

namespace pixel_features_test {

using specimen::Lab;
using specimen::PixelFeatures;
using specimen::Raster;
using specimen::Rgb;

/// All features of a picture, row by row.
std::vector<float> all_of(const PixelFeatures& features) {
  std::vector<float> all;
  std::vector<float> row(static_cast<std::size_t>(features.cols()) *
                         static_cast<std::size_t>(features.count()));
  for (int r = 0; r < features.rows(); ++r) {
    features.read(r, 0, features.cols(), row.data());
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

float feature_at(const PixelFeatures& features, int row, int col, const std::string& name) {
  const auto names =
      specimen::feature_names((features.count() - PixelFeatures::at_first) / PixelFeatures::at_others + 1);
  std::vector<float> values(static_cast<std::size_t>(features.count()));
  features.read(row, col, col + 1, values.data());
  return values[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
}

Raster<Lab> noisy(int rows, int cols) {
  Raster<Rgb> picture(rows, cols, Rgb{120, 130, 140});
  specimen_test::add_noise(picture, 60);
  return specimen::to_lab(picture);
}

TEST(PixelFeatures, EvenColourHasItselfAndNoDifferences) {
  const PixelFeatures features(Raster<Lab>(20, 30, Lab{128, 150, 100}), 4, 1);
  const auto names = specimen::feature_names(4);
  ASSERT_EQ(static_cast<int>(names.size()), features.count());
  std::vector<float> values(names.size());
  features.read(13, 17, 18, values.data());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const float wanted = names[i].starts_with("L ")   ? static_cast<float>(128 / 2.55)
                         : names[i].starts_with("a ") ? 22.0F
                         : names[i].starts_with("b ") ? -28.0F
                                                      : 0.0F;
    EXPECT_NEAR(values[i], wanted, wanted == 0 ? 0.05 : 1e-4) << names[i];
  }
}

TEST(PixelFeatures, PartsOfARowAreThoseOfTheWhole) {
  const PixelFeatures features(noisy(37, 53), 5, 2);
  const std::vector<float> all = all_of(features);
  const auto count = static_cast<std::size_t>(features.count());
  for (const int row : {0, 17, 36})
    for (const int col : {0, 1, 31, 52}) {
      std::vector<float> one(count);
      features.read(row, col, col + 1, one.data());
      const auto at = static_cast<std::ptrdiff_t>(
          (static_cast<std::size_t>(row) * 53 + static_cast<std::size_t>(col)) * count);
      EXPECT_TRUE(std::equal(one.begin(), one.end(), all.begin() + at)) << row << " " << col;
    }
}

TEST(PixelFeatures, AnyNumberOfThreadsGivesTheSameBits) {
  const Raster<Lab> picture = noisy(150, 90);
  EXPECT_EQ(all_of({picture, 6, 1}), all_of({picture, 6, 5}));
}

TEST(PixelFeatures, ScaleAveragesAsItsGaussianDoes) {
  Raster<Lab> picture(129, 129, Lab{0, 128, 128});
  picture(64, 64).l_code = 255;
  const PixelFeatures features(picture, 5, 1);
  for (const auto& [scale, variance] : {std::pair(2, 1.0), std::pair(4, 5.0), std::pair(8, 21.0)}) {
    double sum = 0, squares = 0;
    for (int r = 0; r < 129; ++r)
      for (int c = 0; c < 129; ++c) {
        const auto l = static_cast<double>(feature_at(features, r, c, "L at scale " + std::to_string(scale)));
        sum += l;
        squares += l * (c - 64) * (c - 64);
      }
    EXPECT_NEAR(sum, 100, 1) << scale;
    // Between the places of the scale the values lie on lines, which adds (scale^2 - 1) / 6.
    EXPECT_NEAR(squares / sum, variance + (scale * scale - 1) / 6.0, 0.05 * variance + 0.05) << scale;
  }
}

TEST(PixelFeatures, EdgeHasAGradientAndARoughPartADeviation) {
  Raster<Lab> picture(64, 64, Lab{50, 128, 128});
  for (int r = 0; r < 64; ++r)
    for (int c = 32; c < 64; ++c) picture(r, c).l_code = (r + c) % 2 == 0 ? 255 : 0;
  const PixelFeatures features(picture, 4, 1);
  EXPECT_EQ(feature_at(features, 32, 10, "gradient of L at scale 1"), 0);
  EXPECT_GT(feature_at(features, 32, 32, "gradient of L at scale 1"), 3);
  EXPECT_NEAR(feature_at(features, 32, 10, "deviation of L at scale 4"), 0, 0.1);
  EXPECT_NEAR(feature_at(features, 32, 54, "deviation of L at scale 4"), 50, 1);
  // Up to the edge the calmest window round a pixel of the even part lies in it.
  EXPECT_LT(feature_at(features, 32, 28, "deviation of L at scale 4"), 8);
}

TEST(PixelFeatures, TensorTellsStripesFromDots) {
  Raster<Lab> picture(64, 160, Lab{100, 128, 128});
  for (int r = 0; r < 64; ++r)
    for (int c = 0; c < 160; ++c) {
      if (c < 80 && c % 4 < 2) picture(r, c).l_code = 200;
      if (c >= 80 && c % 4 < 2 && r % 4 < 2) picture(r, c).l_code = 200;
    }
  const PixelFeatures features(picture, 4, 1);
  const float stripes = feature_at(features, 32, 40, "edges along at scale 8");
  const float dots = feature_at(features, 32, 120, "edges along at scale 8");
  EXPECT_LT(stripes, 1);
  EXPECT_GT(dots, 4);
  EXPECT_GT(feature_at(features, 32, 40, "edges across at scale 8"), 5);
}

TEST(PixelFeatures, LargerPicturesHaveMoreScalesUpToSeven) {
  EXPECT_EQ(specimen::scales_for(10, 10), 3);
  EXPECT_EQ(specimen::scales_for(512, 800), 4);
  EXPECT_EQ(specimen::scales_for(2272, 2104), 6);
  EXPECT_EQ(specimen::scales_for(100'000, 100'000), 7);
}

TEST(PixelFeatures, PictureOfOnePixelHasFeaturesToo) {
  const PixelFeatures features(Raster<Lab>(1, 1, Lab{255, 128, 128}), 7, 1);
  EXPECT_NEAR(feature_at(features, 0, 0, "L at scale 64"), 100, 1e-3);
}

}  // namespace pixel_features_test
