#include "libmpm/solver/moving/moving_points.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace moving_points_test {

template <class Real>
class MovingPoints : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(MovingPoints, Precisions);

/// A point whose every field tells its number.
template <class Real>
typename mpm::MovingPoints<Real>::Loose point(std::uint32_t id, int row, int col, int fields) {
  typename mpm::MovingPoints<Real>::Loose loose;
  loose.id = id;
  loose.tile = {row, col};
  for (int f = 0; f < fields; ++f)
    loose.values[static_cast<std::size_t>(f)] = static_cast<Real>(id + 1) + static_cast<Real>(f) / 64;
  return loose;
}

template <class Real>
struct Holds {
  mpm::TilePlace tile;
  bool intact = true;
};
template <class Real>
std::map<std::uint32_t, Holds<Real>> content(const mpm::MovingPoints<Real>& points) {
  std::map<std::uint32_t, Holds<Real>> all;
  for (int row = 0; row < points.rows(); ++row) {
    std::int64_t count = 0;
    points.for_each(row, [&](const auto& slot) {
      ++count;
      Holds<Real> holds{{slot.row, slot.block * points.lanes() + slot.lane}, true};
      for (int f = 0; f < points.layout().fields; ++f)
        holds.intact &=
            points.value(slot, f) == static_cast<Real>(points.id(slot) + 1) + static_cast<Real>(f) / 64;
      EXPECT_TRUE(all.emplace(points.id(slot), holds).second) << "point " << points.id(slot) << " twice";
    });
    EXPECT_EQ(count, points.points(row));
    EXPECT_EQ(count == 0, points.is_empty(row));
  }
  return all;
}

TYPED_TEST(MovingPoints, HoldEveryPointOnceWhateverComesAndGoes) {
  mpm::moving::OptionalFields optional;
  optional.affine = true;
  for (const int lanes : {2, 4, 8, 16}) {
    mpm::MovingPoints<TypeParam> points(3, 13, lanes, mpm::record_layout(optional));
    EXPECT_EQ(points.blocks(), (13 + lanes - 1) / lanes);
    std::map<std::uint32_t, mpm::TilePlace> expected;
    std::mt19937 random(3);
    std::uint32_t next = 0;
    for (int round = 0; round < 600; ++round) {
      // Crowds come and go in turn, so that rows grow and are trimmed.
      const bool comes = random() % 10 < (round / 100 % 2 == 0 ? 8U : 2U) || expected.empty();
      if (comes) {
        const int row = static_cast<int>(random() % 3);
        const int col = static_cast<int>(random() % 13);
        points.insert(point<TypeParam>(next, row, col, points.layout().fields));
        expected[next++] = {row, col};
        continue;
      }
      auto victim = expected.begin();
      std::advance(victim, random() % expected.size());
      bool taken = false;
      for (int row = 0; row < points.rows() && !taken; ++row) {
        for (int block = 0; block < points.blocks() && !taken; ++block) {
          points.for_each_of_block(row, block, [&](const auto& slot) {
            if (taken || points.id(slot) != victim->first) return;
            const auto loose = points.take_out(slot);
            taken = true;
            EXPECT_EQ(loose.id, victim->first);
            EXPECT_EQ(loose.tile, victim->second);
            EXPECT_EQ(loose.values[0], static_cast<TypeParam>(victim->first + 1));
          });
          if (taken) points.trim(row, block);
        }
      }
      ASSERT_TRUE(taken);
      expected.erase(victim);
    }
    const auto all = content(points);
    ASSERT_EQ(all.size(), expected.size());
    for (const auto& [id, holds] : all) {
      EXPECT_TRUE(holds.intact) << "point " << id;
      EXPECT_EQ(holds.tile, expected.at(id));
    }
  }
}

TYPED_TEST(MovingPoints, FillFreedLanesFirstAndGiveUpEmptyRecords) {
  mpm::MovingPoints<TypeParam> points(1, 4, 4, mpm::record_layout({}));
  for (std::uint32_t id = 0; id < 3; ++id) points.insert(point<TypeParam>(id, 0, 1, points.layout().fields));
  EXPECT_EQ(points.used(0, 0), 3) << "points of one tile lie in one lane";
  points.insert(point<TypeParam>(3, 0, 2, points.layout().fields));
  EXPECT_EQ(points.used(0, 0), 3);
  EXPECT_EQ(points.take_out({0, 0, 0, 1}).id, 0U);
  points.trim(0, 0);
  EXPECT_EQ(points.used(0, 0), 3) << "other records still hold points";
  EXPECT_EQ(points.take_out({0, 0, 2, 1}).id, 2U);
  points.trim(0, 0);
  EXPECT_EQ(points.used(0, 0), 2);
  points.insert(point<TypeParam>(4, 0, 1, points.layout().fields));
  EXPECT_EQ(points.id({0, 0, 0, 1}), 4U);
  EXPECT_EQ(points.used(0, 0), 2);
}

// An empty lane must add nothing to any sum and never be suspect.
TYPED_TEST(MovingPoints, StayWhereTheyAreInARowThatWasReserved) {
  const mpm::moving::RecordLayout layout = mpm::record_layout({});
  mpm::MovingPoints<TypeParam> points(1, 12, 4, layout);
  points.reserve(0, {2, 0, 1});
  const TypeParam* const records = points.tile_row(0, 0).records;
  std::uint32_t id = 0;
  for (const int col : {0, 0, 3, 9}) points.insert(point<TypeParam>(id++, 0, col, layout.fields));
  points.insert(point<TypeParam>(id++, 0, 0, layout.fields));  // one from beside it
  EXPECT_EQ(points.tile_row(0, 0).records, records);
  EXPECT_EQ(points.used(0, 0), 3);
  EXPECT_EQ(points.used(0, 1), 0);
  points.insert(point<TypeParam>(id++, 0, 5, layout.fields));
  EXPECT_EQ(points.points(0), 6);
  for (const auto& [one, holds] : content(points)) EXPECT_TRUE(holds.intact) << one;
}

TYPED_TEST(MovingPoints, EmptyLanesCarryNothing) {
  mpm::moving::OptionalFields optional;
  optional.tension = true;
  mpm::MovingPoints<TypeParam> points(1, 4, 4, mpm::record_layout(optional));
  points.insert(point<TypeParam>(0, 0, 0, points.layout().fields));
  for (int lane = 1; lane < 4; ++lane) {
    for (const int f : {mpm::moving::mass, mpm::moving::volume, mpm::moving::sxx, mpm::moving::syy,
                        mpm::moving::sxy, mpm::moving::lame, mpm::moving::shear, mpm::moving::vx})
      EXPECT_EQ(points.value({0, 0, 0, lane}, f), 0);
    EXPECT_GE(points.value({0, 0, 0, lane}, points.layout().tension), mpm::kernels::unreachable);
  }
}

}  // namespace moving_points_test
