#include "apps/reproduce/crack_place.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace crack_place_test {

using namespace app::reproduce;

/// 60 mm square of 1 mm pixels with nothing failed; the peak is at 100e-6.
struct Square {
  Square() {
    mask.labels = specimen::Raster<std::uint8_t>(60, 60, specimen::phase::mortar);
    mask.pixel_size = 1e-3;
    result.peak_stress = 1e6;
    result.peak_strain = 100e-6;
    result.history = {{.strain = 100e-6, .stress = 1e6}, {.strain = 300e-6, .stress = 0}};
    result.failure_strain = mpm::PixelField<float>::Constant(60, 60, std::numeric_limits<float>::quiet_NaN());
  }
  /// @param height  of the row of pixels [mm from below].
  void crack(int height, int first_col, int last_col, float strain) {
    for (int col = first_col; col <= last_col; ++col) result.failure_strain(59 - height, col) = strain;
  }
  specimen::LabelledMask mask;
  mpm::Result result;
};

const specimen::Ellipse aggregate{30e-3, 30e-3, 15e-3, 10e-3, 0};  // top at 40 mm, bottom at 20 mm

TEST(CrackPlace, IsWhereMostFailAfterThePeak) {
  Square square;
  square.crack(40, 10, 50, 120e-6F);
  square.crack(10, 10, 20, 120e-6F);
  const CrackPlace place = crack_between(square.mask, square.result, 0, 60e-3);
  EXPECT_NEAR(place.height, 40.5e-3, 1e-9);
  EXPECT_NEAR(place.share, 41.0 / 52, 1e-12);
}

TEST(CrackPlace, IsNowhereInARunWithoutAPeak) {
  Square square;
  square.crack(40, 10, 50, 120e-6F);
  square.result.history.pop_back();
  EXPECT_TRUE(std::isnan(crack_between(square.mask, square.result, 0, 60e-3).height));
}

TEST(CrackPlace, WhatFailsUpToThePeakOrBeyondTheEndIsNoCrack) {
  Square square;
  square.crack(40, 0, 59, 100e-6F);
  square.crack(30, 0, 59, 151e-6F);
  square.crack(20, 0, 3, 150e-6F);
  EXPECT_NEAR(crack_between(square.mask, square.result, 0, 60e-3).height, 20.5e-3, 1e-9);
}

TEST(CrackPlace, LooksAtItsColumnsAlone) {
  Square square;
  square.crack(50, 0, 29, 120e-6F);
  square.crack(5, 30, 59, 120e-6F);
  EXPECT_NEAR(crack_between(square.mask, square.result, 0, 30e-3).height, 50.5e-3, 1e-9);
  EXPECT_NEAR(crack_between(square.mask, square.result, 30e-3, 60e-3).height, 5.5e-3, 1e-9);
}

TEST(CrackPlace, SideOfAnAggregate) {
  for (const auto& [height, side] : {std::pair{40, CrackSide::top},
                                     {44, CrackSide::top},
                                     {46, CrackSide::elsewhere},
                                     {30, CrackSide::elsewhere},
                                     {20, CrackSide::bottom},
                                     {13, CrackSide::elsewhere}}) {
    Square square;
    square.crack(height, 0, 59, 120e-6F);
    EXPECT_EQ(crack_beside(square.mask, square.result, aggregate).side, side) << height;
  }
}

TEST(CrackPlace, WithoutFailuresIsNowhere) {
  const Square square;
  const CrackPlace place = crack_between(square.mask, square.result, 0, 60e-3);
  EXPECT_TRUE(std::isnan(place.height));
  EXPECT_EQ(place.share, 0);
  EXPECT_EQ(crack_beside(square.mask, square.result, aggregate).side, CrackSide::elsewhere);
}

}  // namespace crack_place_test
