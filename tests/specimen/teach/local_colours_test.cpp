#include "specimen/teach/local_colours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "specimen/body/raster.hpp"

namespace local_colours_test {

using specimen::ClassShares;
using specimen::Lab;
using specimen::LocalColoursOptions;
using specimen::Raster;

/// A dark disc on the left and a bright one on the right, even but for little noise, in rough ground of a
/// lightness between.
struct Scene {
  static constexpr int rows = 100, cols = 200;
  Raster<Lab> picture{rows, cols};
  ClassShares shares{rows, cols, 3};  ///< of void, which is nowhere, disc and ground

  static double away(int r, int c) {
    return std::min(std::hypot(r - 50.0, c - 50.0), std::hypot(r - 50.0, c - 150.0)) - 30;
  }

  /// @param grown  how many pixels too large the shares show the discs, whose edges are soft in them, as
  /// windows over both sides make them.
  explicit Scene(double grown) {
    specimen::Random random(5);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < cols; ++c) {
        const bool is_disc = away(r, c) < 0;
        const double middle = !is_disc ? 130 : c < cols / 2 ? 100 : 160, spread = is_disc ? 8 : 60;
        const auto code = [&](double mean, double wide) {
          return static_cast<std::uint8_t>(std::lround(mean + random.uniform(-wide, wide)));
        };
        const auto l = code(middle, spread), a = code(128, spread / 4), b = code(128, spread / 4);
        picture(r, c) = Lab{l, a, b};
        const double disc = std::clamp(0.5 - (away(r, c) - grown) / 16, 0.1, 0.9);
        shares.at(r, c)[0] = 5;
        shares.at(r, c)[1] = static_cast<std::uint8_t>(std::lround(disc * 250));
        shares.at(r, c)[2] = static_cast<std::uint8_t>(250 - shares.at(r, c)[1]);
      }
  }

  static int wrong(const ClassShares& found) {
    int count = 0;
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < cols; ++c)
        count += (found.at(r, c)[1] > found.at(r, c)[2]) != (away(r, c) < 0) ? 1 : 0;
    return count;
  }
};

TEST(LocalColours, BoundariesThatAreSomePixelsOffMoveToWhereTheColoursPart) {
  for (const double grown : {3.0, -3.0}) {
    const Scene scene(grown);
    const int before = Scene::wrong(scene.shares);
    EXPECT_GT(before, 1000);
    EXPECT_LT(Scene::wrong(specimen::sharpened_by_colours(scene.shares, scene.picture, {}, 2)), before / 2);
  }
}

TEST(LocalColours, WithoutTrustInColoursOnlyNeighboursAreHeard) {
  const Scene scene(3);
  LocalColoursOptions options;
  options.trust = 0;
  EXPECT_GT(Scene::wrong(specimen::sharpened_by_colours(scene.shares, scene.picture, options, 2)), 900);
}

TEST(LocalColours, SharesOfAPixelMakeUpOne) {
  const Scene scene(3);
  const ClassShares found = specimen::sharpened_by_colours(scene.shares, scene.picture, {}, 2);
  for (int c = 0; c < Scene::cols; ++c)
    EXPECT_NEAR(found.at(60, c)[0] + found.at(60, c)[1] + found.at(60, c)[2], 255, 2);
}

TEST(LocalColours, AreTheSameOnAnyNumberOfThreads) {
  const Scene scene(2);
  EXPECT_EQ(specimen::sharpened_by_colours(scene.shares, scene.picture, {}, 1).data,
            specimen::sharpened_by_colours(scene.shares, scene.picture, {}, 4).data);
}

TEST(LocalColours, BandsLeaveNoSeam) {
  // Rows that are all alike stay so, wherever a band (64 rows) ends.
  constexpr int rows = 200, cols = 40;
  Raster<Lab> picture(rows, cols);
  ClassShares shares(rows, cols, 2);
  specimen::Random random(2);
  for (int c = 0; c < cols; ++c) {
    const Lab lab{static_cast<std::uint8_t>(std::lround(random.uniform(80, 160))), 128, 128};
    const auto share = static_cast<std::uint8_t>(std::lround(random.uniform(0, 255)));
    for (int r = 0; r < rows; ++r) {
      picture(r, c) = lab;
      shares.at(r, c)[0] = share;
      shares.at(r, c)[1] = static_cast<std::uint8_t>(255 - share);
    }
  }
  const ClassShares found = specimen::sharpened_by_colours(shares, picture, {}, 3);
  for (int r = 60; r < 132; ++r)
    for (int c = 0; c < cols; ++c) EXPECT_NEAR(found.at(r, c)[0], found.at(100, c)[0], 1);
}

TEST(LocalColours, WhatIsSureStaysThoughAClassIsNowhereNear) {
  Raster<Lab> picture(90, 90, Lab{120, 128, 128});
  ClassShares shares(90, 90, 3);
  for (int r = 0; r < 90; ++r)
    for (int c = 0; c < 90; ++c) shares.at(r, c)[2] = 255;
  const ClassShares found = specimen::sharpened_by_colours(shares, picture, {}, 1);
  for (int c = 0; c < 90; ++c) EXPECT_GT(found.at(45, c)[2], 250);
}

}  // namespace local_colours_test
