#include "apps/report/key_figures.hpp"

#include <gtest/gtest.h>

#include "tests/apps/fake_run.hpp"

namespace failure_table_test {

using namespace output;

TEST(FailureTable, CountsByPhaseAndMode) {
  FakeRun run = still_run({"1223", "2233"});
  run.result.failure_mode << 0, 1, 1, 2,  //
      2, 0, 0, 1;
  run.result.crush_strain = run.result.failure_strain;
  run.result.crush_strain(0, 1) = 1e-3F;
  const auto rows = failures_by_phase(run.record());
  ASSERT_EQ(rows.size(), 3U) << "phases that the mask does not hold have no row";
  EXPECT_EQ(rows[0].phase, "aggregate");
  EXPECT_EQ(rows[0].intact(), 1);
  EXPECT_EQ(rows[1].phase, "mortar");
  EXPECT_EQ(rows[1].points, 4);
  EXPECT_EQ(rows[1].tension, 2);
  EXPECT_EQ(rows[1].shear, 1);
  EXPECT_EQ(rows[1].crushed, 1);
  EXPECT_EQ(rows[1].intact(), 1);
  EXPECT_EQ(rows[2].phase, "itz");
  EXPECT_EQ(rows[2].tension, 1);
  EXPECT_EQ(rows[2].shear, 1);
}

TEST(FailureTable, GivesTheRestToTheExtraPoints) {
  const FakeRun run = compression_run(60);
  const auto rows = failures_by_phase(run.record());
  const FailureCount extra = failures_of_extra_points(run.record(), rows);
  EXPECT_EQ(extra.points, 2628);
  EXPECT_EQ(extra.tension, 700);
  EXPECT_EQ(extra.shear, 60);
}

}  // namespace failure_table_test
