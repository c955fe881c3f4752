#include "specimen/convert/shapes.hpp"

#include <gtest/gtest.h>

namespace shapes_test {

using specimen::Raster;
using specimen::Shapes;
using specimen::ValueShape;

/// 0 with a square of 2 x 2 of 1 in it, a pixel of 1 in a corner, and a column outside.
Raster<std::int32_t> small_map() {
  Raster<std::int32_t> code(5, 7, 0);
  for (const auto& [r, c] : {std::pair(2, 2), {2, 3}, {3, 2}, {3, 3}, {0, 0}}) code(r, c) = 1;
  for (int r = 0; r < 5; ++r) code(r, 6) = -1;
  return code;
}

TEST(Shapes, CountPiecesEdgesAndTheBorder) {
  const Shapes shapes = shapes_of(small_map(), 2);
  const ValueShape &matrix = shapes.of[0], &squares = shapes.of[1];
  EXPECT_EQ(squares.area, 5);
  EXPECT_EQ(squares.pieces, 2);
  EXPECT_EQ(squares.largest, 4);
  EXPECT_DOUBLE_EQ(squares.typical, (4 * 4 + 1 * 1) / 5.0);
  EXPECT_EQ(squares.perimeter, 8 + 2);
  EXPECT_EQ(matrix.area, 5 * 7 - 5 - 5);
  EXPECT_EQ(matrix.perimeter, 10 + 5);
  EXPECT_EQ(shapes.contact(0, 1), 10);
  EXPECT_DOUBLE_EQ(matrix.reach, 1);          // all 15 edges
  EXPECT_DOUBLE_EQ(squares.reach, 8.0 / 15);  // those of the larger square
  EXPECT_DOUBLE_EQ(squares.border, 0);        // which is in the middle
  EXPECT_GT(matrix.border, 0.8);
}

TEST(Shapes, NeighboursAreOtherValuesThatAreTouched) {
  Raster<std::int32_t> code(1, 6);
  code.data = {0, 1, 1, 2, 1, 0};
  EXPECT_EQ(neighbours_of(code, 3), (std::vector<int>{1, 2, 1}));
}

TEST(Shapes, ARegionIsSolidAndALineIsNot) {
  Raster<std::int32_t> code(20, 20, 0);
  for (int r = 0; r < 20; ++r) code(r, 10) = 1;
  const std::vector<double> solid = solidity(code, 2);
  EXPECT_GT(solid[0], 0.9);
  EXPECT_EQ(solid[1], 0);
}

}  // namespace shapes_test
