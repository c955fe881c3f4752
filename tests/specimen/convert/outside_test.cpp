#include "specimen/convert/outside.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/specimen/drawn.hpp"
#include "tests/specimen/known_truth.hpp"

namespace outside_test {

using specimen::OutsideMask;
using specimen::Raster;
using specimen_test::known_truth;
using specimen_test::KnownTruth;
using specimen_test::picture_of;

/// Whether a pixel lies in the disc, or in the tilted square, that the picture shows.
bool in_core(int r, int c) { return (r - 60.0) * (r - 60.0) + (c - 80.0) * (c - 80.0) < 55.0 * 55.0; }
bool in_tilted(int r, int c) {
  const double x = (c - 80) * 0.97 + (r - 60) * 0.24, y = (r - 60) * 0.97 - (c - 80) * 0.24;
  return std::abs(x) < 60 && std::abs(y) < 45;
}

template <class Inside>
Raster<std::int32_t> map_within(Inside inside, std::int32_t outside) {
  const KnownTruth truth = known_truth();
  Raster<std::int32_t> code(truth.rows, truth.cols, outside);
  for (int r = 0; r < code.rows; ++r)
    for (int c = 0; c < code.cols; ++c)
      if (inside(r, c)) code(r, c) = truth.labels(r, c);
  return code;
}

template <class Inside>
void expect_found(const Raster<std::int32_t>& code, Inside inside) {
  const OutsideMask mask = specimen::outside_of_map(code, false);
  ASSERT_FALSE(mask.empty());
  for (int r = 0; r < code.rows; ++r)
    for (int c = 0; c < code.cols; ++c) {
      if (code(r, c) == code(0, 0)) continue;  // pores of the same value may open to the outside
      ASSERT_EQ(mask(r, c), 0) << r << " " << c << inside(r, c);
    }
  EXPECT_EQ(mask(0, 0), 1);
  EXPECT_EQ(mask(code.rows - 1, code.cols - 1), 1);
}

TEST(Outside, OfACoreAndOfATiltedCutIsFound) {
  for (const std::int32_t value : {0, 3, 9}) {
    expect_found(map_within(in_core, value), in_core);
    expect_found(map_within(in_tilted, value), in_tilted);
  }
}

TEST(Outside, TheMatrixAtTheCornersIsNot) {
  const auto everywhere = [](int, int) { return true; };
  EXPECT_TRUE(specimen::outside_of_map(map_within(everywhere, 0), false).empty());
  Raster<std::int32_t> one_stone(60, 60, 0);
  specimen_test::draw_disc(one_stone, 30, 30, 20, 1);
  EXPECT_TRUE(specimen::outside_of_map(one_stone, false).empty()) << "a stone in a matrix";
}

TEST(Outside, StonesAtTheCornersAreNot) {
  Raster<std::int32_t> code = map_within([](int, int) { return true; }, 0);
  for (const auto& [r, c] :
       {std::pair(0, 0), {0, code.cols - 1}, {code.rows - 1, 0}, {code.rows - 1, code.cols - 1}})
    specimen_test::draw_disc(code, r, c, 9, 1);
  EXPECT_TRUE(specimen::outside_of_map(code, false).empty());
  EXPECT_FALSE(specimen::outside_of_map(code, true).empty()) << "unless it is said to be";
}

TEST(Outside, OfAPhotographIsEvenBlackOrWhite) {
  const KnownTruth truth = known_truth();
  for (const double beyond : {0.0, 255.0}) {
    Raster<double> gray(truth.rows, truth.cols, beyond);
    specimen::Random random(1);
    for (int r = 0; r < gray.rows; ++r)
      for (int c = 0; c < gray.cols; ++c)
        if (in_core(r, c))
          gray(r, c) = std::floor(80 + 60 * truth.labels(r, c) / 2.0 + random.uniform(-9, 9));
    const OutsideMask mask = specimen::outside_of_photograph(picture_of(gray), false);
    ASSERT_FALSE(mask.empty());
    for (int r = 0; r < gray.rows; ++r)
      for (int c = 0; c < gray.cols; ++c) ASSERT_EQ(mask(r, c) != 0, !in_core(r, c));
    gray.data.assign(gray.size(), 120.0);
    EXPECT_TRUE(specimen::outside_of_photograph(picture_of(gray), false).empty());
  }
}

TEST(Outside, TransparencyAndNotANumberAreOutside) {
  specimen::Picture picture = picture_of(Raster<double>(2, 3, 5.0));
  EXPECT_TRUE(specimen::without_value(picture).empty());
  picture.gray(1, 1) = std::numeric_limits<double>::quiet_NaN();
  picture.opacity = Raster<std::uint8_t>(2, 3, 255);
  picture.opacity(0, 2) = 20;
  EXPECT_EQ(specimen::without_value(picture).data, (std::vector<std::uint8_t>{0, 0, 1, 0, 1, 0}));
}

}  // namespace outside_test
