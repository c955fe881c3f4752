#include "libmpm/solver/quasi_static/pieces.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pieces_test {

using mpm::Pieces;

/// Of a drawing, its upper row first; # has stiffness.
Pieces pieces_of(const std::vector<std::string>& drawing) {
  const auto rows = static_cast<int>(drawing.size());
  return {static_cast<int>(drawing.front().size()), rows, [&](int row, int col) {
            return drawing[static_cast<std::size_t>(rows - 1 - row)][static_cast<std::size_t>(col)] == '#';
          }};
}

TEST(Pieces, JoinThePlatensThroughSharedNodes) {
  EXPECT_TRUE(pieces_of({"#..", ".#.", "..#"}).joins_platens());  // corner to corner
  EXPECT_FALSE(pieces_of({"#..", "...", "..#"}).joins_platens());
  EXPECT_FALSE(pieces_of({"##.", "...", "###"}).joins_platens());
}

TEST(Pieces, AreHeldByEitherPlaten) {
  const Pieces pieces = pieces_of({"#....", ".....", "..#..", ".....", "....#"});
  EXPECT_TRUE(pieces.is_held(0, 4));
  EXPECT_TRUE(pieces.is_held(4, 0));
  EXPECT_FALSE(pieces.is_held(2, 2));
  EXPECT_TRUE(pieces.is_above(4, 0));
  EXPECT_FALSE(pieces.is_above(0, 4));
  EXPECT_TRUE(pieces.is_below(1, 4));
  EXPECT_FALSE(pieces.is_below(2, 2));
}

}  // namespace pieces_test
