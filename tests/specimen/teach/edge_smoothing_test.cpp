#include "specimen/teach/edge_smoothing.hpp"

#include <gtest/gtest.h>

namespace edge_smoothing_test {

using specimen::ClassShares;
using specimen::Lab;
using specimen::Raster;

/// Dark to the left of a column, bright to the right of it.
Raster<Lab> two_halves(int rows, int cols, int at) {
  Raster<Lab> picture(rows, cols, Lab{60, 128, 128});
  for (int r = 0; r < rows; ++r)
    for (int c = at; c < cols; ++c) picture(r, c).l_code = 200;
  return picture;
}

/// Class 1 right of a column, with some pixels turned to the other class.
ClassShares noisy_shares(int rows, int cols, int at, double wrong) {
  specimen::Random random(3);
  ClassShares shares(rows, cols, 2);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c) {
      const bool is_right = (c >= at) != (random.uniform() < wrong);
      shares.at(r, c)[0] = is_right ? 0 : 255;
      shares.at(r, c)[1] = is_right ? 255 : 0;
    }
  return shares;
}

TEST(EdgeSmoothing, ConstantSharesStay) {
  ClassShares shares(40, 30, 3);
  for (std::size_t i = 0; i < shares.data.size(); i += 3)
    shares.data[i] = 100, shares.data[i + 1] = 150, shares.data[i + 2] = 5;
  const ClassShares smooth = specimen::smoothed_along_edges(shares, two_halves(40, 30, 11), 4, 5, 1);
  for (std::size_t i = 0; i < shares.data.size(); ++i) EXPECT_NEAR(smooth.data[i], shares.data[i], 1);
}

TEST(EdgeSmoothing, NoiseGoesAndTheBoundaryStaysAtTheEdgeOfThePicture) {
  // The shares put the boundary two pixels too far to the left.
  const ClassShares shares = noisy_shares(200, 80, 38, 0.2);
  const ClassShares smooth = specimen::smoothed_along_edges(shares, two_halves(200, 80, 40), 8, 5, 2);
  int wrong = 0;
  for (int r = 0; r < 200; ++r)
    for (int c = 0; c < 80; ++c) wrong += (smooth.at(r, c)[1] > 127) != (c >= 40);
  EXPECT_LT(wrong, 200 * 80 / 100);
}

TEST(EdgeSmoothing, IsTheSameOnAnyNumberOfThreadsAndNothingWithoutARadius) {
  const ClassShares shares = noisy_shares(301, 50, 20, 0.3);
  const Raster<Lab> picture = two_halves(301, 50, 20);
  EXPECT_EQ(specimen::smoothed_along_edges(shares, picture, 5, 5, 1).data,
            specimen::smoothed_along_edges(shares, picture, 5, 5, 4).data);
  EXPECT_EQ(specimen::smoothed_along_edges(shares, picture, 0, 5, 1).data, shares.data);
}

TEST(EdgeSmoothing, BandsLeaveNoSeam) {
  // The rows between two bands (64) are like any others: shares that change by rows only, in an even picture.
  ClassShares shares(160, 20, 2);
  for (int r = 0; r < 160; ++r)
    for (int c = 0; c < 20; ++c)
      shares.at(r, c)[0] = static_cast<std::uint8_t>(r),
                   shares.at(r, c)[1] = static_cast<std::uint8_t>(255 - r);
  const ClassShares smooth =
      specimen::smoothed_along_edges(shares, Raster<Lab>(160, 20, Lab{99, 128, 128}), 6, 5, 1);
  for (int r = 20; r < 140; ++r) EXPECT_NEAR(smooth.at(r, 10)[0], r, 1) << r;
}

TEST(EdgeSmoothing, SmallPicturesWork) {
  ClassShares shares(1, 2, 2);
  shares.data = {255, 0, 0, 255};
  const ClassShares smooth = specimen::smoothed_along_edges(shares, Raster<Lab>(1, 2, Lab{}), 9, 5, 1);
  EXPECT_NEAR(smooth.data[0], 128, 1);
}

}  // namespace edge_smoothing_test
