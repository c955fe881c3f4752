#include "specimen/convert/smoothing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace smoothing_test {

using specimen::Raster;
using specimen::Rgb;

Raster<double> noise(int rows, int cols, double scale) {
  std::mt19937_64 random(3);
  Raster<double> r(rows, cols);
  for (double& v : r.data) v = static_cast<double>(random() % 1'000'003) * scale;
  return r;
}

double median_by_sorting(const Raster<double>& picture, int row, int col, int reach) {
  std::vector<double> values;
  for (int r = row - reach; r <= row + reach; ++r)
    for (int c = col - reach; c <= col + reach; ++c)
      if (picture.contains(r, c)) values.push_back(picture(r, c));
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

TEST(Smoothing, MedianIsTheMiddleOfTheSortedWindow) {
  const Raster<double> picture = noise(13, 17, 0.25);
  for (const int edge : {1, 3, 7}) {
    const Raster<double> smooth = specimen::median_of(picture, edge);
    for (int r = 0; r < 13; ++r)
      for (int c = 0; c < 17; ++c) ASSERT_EQ(smooth(r, c), median_by_sorting(picture, r, c, edge / 2));
  }
}

TEST(Smoothing, MedianOfVeryManyLevelsIsRightToTheirStep) {
  const Raster<double> picture = noise(300, 300, 1e-3);  // 90,000 pixels, nearly all of their own
  const Raster<double> smooth = specimen::median_of(picture, 3);
  for (int c = 1; c < 300; c += 37)
    EXPECT_NEAR(smooth(150, c), median_by_sorting(picture, 150, c, 1), 1000.0 / 65535);
}

TEST(Smoothing, ShrinkingAveragesSquaresAndWhatIsLeftAtTheEdge) {
  Raster<double> picture(3, 5);
  for (std::size_t i = 0; i < picture.size(); ++i) picture.data[i] = static_cast<double>(i);
  const Raster<double> small = specimen::shrunk(picture, 2);
  ASSERT_EQ(small.rows, 2);
  ASSERT_EQ(small.cols, 3);
  EXPECT_EQ(small.data, (std::vector<double>{3, 5, 6.5, 10.5, 12.5, 14}));
  const Raster<Rgb> colour(4, 4, Rgb{200, 100, 255});
  EXPECT_EQ(specimen::shrunk(colour, 3).data, std::vector<Rgb>(4, Rgb{200, 100, 255}));
}

TEST(Smoothing, LocalMeanKeepsAConstantAndAveragesASpot) {
  EXPECT_EQ(specimen::local_mean(Raster<double>(4, 5, 7.0), 3).data, std::vector<double>(20, 7));
  Raster<double> spot(5, 5, 0.0);
  spot(2, 2) = 9;
  const Raster<double> mean = specimen::local_mean(spot, 3);
  EXPECT_EQ(mean(1, 1), 1);
  EXPECT_EQ(mean(0, 0), 0);
}

TEST(Smoothing, ARimBetweenSmoothPartsIsSmoothAndSandIsRough) {
  Raster<double> picture(20, 40, 10.0);
  for (int r = 0; r < 20; ++r)
    for (int c = 10; c < 40; ++c) picture(r, c) = c < 20 ? 90 : (r + c) % 2 == 0 ? 50 : 70;
  const Raster<double> rough = specimen::roughness(picture, 5);
  for (int c = 0; c < 20; ++c) EXPECT_NEAR(rough(10, c), 0, 1e-6) << c;
  EXPECT_NEAR(rough(10, 30), 10, 0.1);
}

}  // namespace smoothing_test
