#include "specimen/body/mask.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace components_test {

using specimen::Components;
using specimen::connected_pieces;
using specimen::Connectivity;
using specimen::Raster;

Raster<std::uint8_t> raster(int cols, std::vector<std::uint8_t> values) {
  Raster<std::uint8_t> r(static_cast<int>(values.size()) / cols, cols);
  r.data = std::move(values);
  return r;
}

TEST(Components, CornersJoinOnlyWhereAsked) {
  const auto picture = raster(2, {1, 0,  //
                                  0, 1});
  EXPECT_EQ(connected_pieces(picture, Connectivity::edges).count(), 4);
  EXPECT_EQ(connected_pieces(picture, Connectivity::corners).count(), 2);
}

TEST(Components, NumbersPiecesInReadingOrderAndCountsThem) {
  const auto picture = raster(5, {7, 7, 3, 7, 7,  //
                                  7, 3, 3, 3, 7,  //
                                  7, 7, 7, 7, 7});
  const Components pieces = connected_pieces(picture, Connectivity::edges);
  EXPECT_EQ(pieces.area, (std::vector<std::int64_t>{11, 4}));
  EXPECT_EQ(pieces.piece(0, 0), 0);
  EXPECT_EQ(pieces.piece(0, 4), 0);  // joined from below, though met apart
  EXPECT_EQ(pieces.piece(1, 2), 1);
}

TEST(Components, FollowsASpiralAsOnePiece) {
  const int n = 41;
  Raster<std::int32_t> spiral(n, n, 0);
  int r = 0, c = 0, dr = 0, dc = 1;
  const auto free = [&](int row, int col) { return spiral.contains(row, col) && spiral(row, col) == 0; };
  for (int turns = 0; turns < 2;) {
    spiral(r, c) = 1;
    // Two ahead must be free too, so that a gap stays between the arms.
    if (free(r + dr, c + dc) && (!spiral.contains(r + 2 * dr, c + 2 * dc) || free(r + 2 * dr, c + 2 * dc))) {
      r += dr, c += dc, turns = 0;
    } else {
      std::swap(dr, dc);
      dc = -dc;
      ++turns;
    }
  }
  const Components pieces = connected_pieces(spiral, Connectivity::edges);
  EXPECT_EQ(pieces.count(), 2);
  EXPECT_EQ(std::accumulate(pieces.area.begin(), pieces.area.end(), std::int64_t{0}), n * n);
}

}  // namespace components_test
