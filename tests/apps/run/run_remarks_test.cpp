#include "apps/run/run_remarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/text/complaint.hpp"

namespace run_remarks_test {

app::RunRemarks sample() {
  app::RunRemarks remarks;
  remarks.notes = {"the scale was guessed", "\"rings\"\nwere drawn"};
  remarks.estimate_error = true;
  remarks.tolerated.sources = {{"time step", "CFL 0.25", 1e6 / 3, 1e-4 / 7, 0.01, 0.02, 3.5}};
  remarks.checkpoint_every = 0.1;
  return remarks;
}

TEST(RunRemarks, AreReadBackAsTheyWere) {
  const app::RunRemarks read = app::parse_remarks(app::remarks_text(sample()), "x");
  EXPECT_EQ(read.notes, sample().notes);
  EXPECT_TRUE(read.estimate_error);
  EXPECT_EQ(read.checkpoint_every, 0.1);
  ASSERT_EQ(read.tolerated.sources.size(), 1U);
  const output::ErrorSource& source = read.tolerated.sources.front();
  EXPECT_EQ(source.name, "time step");
  EXPECT_EQ(source.compared, "CFL 0.25");
  EXPECT_EQ(source.peak_stress, 1e6 / 3);
  EXPECT_EQ(source.peak_strain, 1e-4 / 7);
  EXPECT_EQ(source.stress_error, 0.01);
  EXPECT_EQ(source.strain_error, 0.02);
  EXPECT_EQ(source.wall_time, 3.5);
}

TEST(RunRemarks, RefuseWhatIsNone) {
  for (const char* text : {"", "no", "[]", "{}", R"({"notes": 3, "estimate_error": true})"}) {
    try {
      (void)app::parse_remarks(text, "a.checkpoint");
      ADD_FAILURE() << text;
    } catch (const app::Rejected& rejected) {
      EXPECT_EQ(rejected.code, app::Exit::data);
      EXPECT_THAT(rejected.what(), testing::StartsWith("a.checkpoint: "));
    }
  }
}

}  // namespace run_remarks_test
