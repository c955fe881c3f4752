#include "apps/study/study_results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/small_study.hpp"

namespace study_table_test {

using namespace app;
using testing::HasSubstr;

TEST(StudyTable, HasARowAMember) {
  const test::TemporaryFolder folder;
  const Study study = test::small_study(
      folder,
      "seeds = [5]\n[vary]\n\"loading.velocity\" = [\"100 mm/s\", \"0.2 m/s\"]\n\"loading.platen\" = "
      "[\"rough\"]\n");
  const std::vector<Member> members = list_members(study);
  StudyResults results;
  results.outcomes.resize(2);
  results.outcomes[0].state = MemberState::done;
  results.outcomes[0].figures.peak_stress = 3.25e6;
  results.outcomes[0].end.platen_work = 1.5;
  results.outcomes[0].figures.stop = mpm::StopReason::drop;
  results.outcomes[1].state = MemberState::failed;
  const std::string csv = table_csv(study_table(study, members, results));
  EXPECT_THAT(csv, HasSubstr("member,id,state,loading.velocity_m_per_s,loading.platen,seed,peak_stress_Pa,"));
  EXPECT_THAT(csv, HasSubstr("\n0," + members[0].id + ",done,0.1,rough,5,3250000,0,"));
  EXPECT_THAT(csv, HasSubstr(",1.5,"));
  EXPECT_THAT(csv, HasSubstr(",drop\n1," + members[1].id + ",failed,0.2,rough,5,,,"));
  EXPECT_THAT(table_csv(timing_table(members, results)),
              HasSubstr("member,id,wall_time_s,instruction_set\n0," + members[0].id + ",0,\n"));
}

TEST(StudyTable, QuotesTextsThatHoldCommas) {
  const mpm::TableColumn column{"a", "J/m", "", std::vector<std::string>{"x", "y, z", "say \"so\""}};
  EXPECT_EQ(table_csv({column}), "a_J_per_m\nx\n\"y, z\"\n\"say \"\"so\"\"\"\n");
}

}  // namespace study_table_test
