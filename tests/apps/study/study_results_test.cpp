#include "apps/study/study_results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <regex>

#include "libmpm/files/result_file.hpp"
#include "tests/apps/small_study.hpp"
#include "tests/apps/triangle.hpp"

namespace study_results_test {

using namespace app;
using testing::HasSubstr;
using testing::StartsWith;

/// A study of three members, into whose folder results are put that were never computed.
class StudyResultsOf : public testing::Test {
 protected:
  void SetUp() override { folder_.open(study_, members_); }

  /// As a version writes it whose help and units are worded otherwise.
  static std::string reworded(const std::string& scene) {
    return std::regex_replace(std::regex_replace(scene, std::regex("# [^\n]*"), "# something else"),
                              std::regex("\"16 mm\""), "\"1.6 cm\"");
  }

  /// @param motion  share of the work of the platens that is motion.
  void put(std::size_t member, int side, int failed, double motion = 0) {
    mpm::Result result = test::triangle(3e6, 1e-4);
    for (mpm::HistoryRow& row : result.history) {
      row.platen_work = row.elastic = 1;
      row.kinetic = motion;
    }
    result.failure_strain = mpm::PixelField<float>::Constant(side, side, std::nanf(""));
    result.failure_mode = mpm::PixelField<std::uint8_t>::Zero(side, side);
    for (int i = 0; i < failed; ++i) result.failure_mode(0, i) = 1;
    result.instruction_set = "baseline";
    mpm::write_result(folder_.result_file(members_[member]).string(), result,
                      reworded(member_scene(*members_[member].settings)));
  }

  test::TemporaryFolder files_;
  StudyFolder folder_{files_ / "out"};
  Study study_ = test::small_study(files_, "seeds = 3\n");
  std::vector<Member> members_ = list_members(study_);
};

TEST_F(StudyResultsOf, KeepTheFiguresAndTheCurveWithItsPeak) {
  put(1, 4, 2);
  folder_.write_failure(study_, members_[2], "it broke");
  const StudyResults results = read_results(folder_, members_);
  EXPECT_EQ(results.outcomes[0].state, MemberState::open);
  EXPECT_EQ(results.outcomes[1].state, MemberState::done);
  EXPECT_EQ(results.outcomes[2].state, MemberState::failed);
  EXPECT_EQ(results.outcomes[2].reason, "it broke");
  EXPECT_TRUE(std::isnan(results.peak_stress()[0]));
  EXPECT_EQ(results.peak_stress()[1], 3e6);
  EXPECT_EQ(results.peak_strain()[1], 1e-4);
  EXPECT_DOUBLE_EQ(results.outcomes[1].end.strain, 3e-4);
  const Curve& curve = results.curves[1];
  EXPECT_LE(curve.strain.size(), 201U);
  EXPECT_EQ(*std::max_element(curve.stress.begin(), curve.stress.end()), 3e6);
  EXPECT_TRUE(results.curves[0].empty());
}

TEST_F(StudyResultsOf, CountTheFailuresOfEachPixel) {
  put(0, 4, 1);
  put(1, 4, 3);
  const CrackCount cracks = read_results(folder_, members_).cracks;
  EXPECT_EQ(cracks.members, 2);
  EXPECT_EQ(cracks.failures(0, 0), 2);
  EXPECT_EQ(cracks.failures(0, 2), 1);
  EXPECT_EQ(cracks.failures(3, 3), 0);
}

TEST_F(StudyResultsOf, CountNothingWherePicturesDiffer) {
  put(0, 4, 1);
  put(1, 5, 1);
  put(2, 4, 1);
  EXPECT_EQ(read_results(folder_, members_).cracks.failures.size(), 0);
}

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

TEST_F(StudyResultsOf, LeaveMembersWithoutAPeakOutOfAllStatistics) {
  put(0, 4, 1);
  put(1, 4, 1);
  mpm::Result rising = test::triangle(5e6, 1e-4);
  rising.history.resize(101);  // to its largest stress
  mpm::write_result(folder_.result_file(members_[2]).string(), rising,
                    reworded(member_scene(*members_[2].settings)));
  const StudyResults results = read_results(folder_, members_);
  EXPECT_TRUE(std::isnan(results.peak_stress()[2]));
  EXPECT_TRUE(std::isnan(results.peak_strain()[2]));
  EXPECT_EQ(results.peak_stress()[1], 3e6);
  EXPECT_EQ(results.without_peak(), 1U);
  EXPECT_THAT(without_peak_text(results), HasSubstr("1 of 3 members reached no peak"));
  const std::string csv = table_csv(study_table(study_, members_, results));
  EXPECT_THAT(csv, HasSubstr("peak_stress_Pa,peak_strain,peak_reached,"));
  EXPECT_THAT(csv, HasSubstr(",3000000,0.0001,1,"));
  EXPECT_THAT(csv, HasSubstr(",,,0,"));
}

TEST_F(StudyResultsOf, SayNothingWhereAllHaveAPeak) {
  put(0, 4, 1);
  EXPECT_EQ(without_peak_text(read_results(folder_, members_)), "");
}

TEST_F(StudyResultsOf, TellHowManyMembersAreNoSlowTests) {
  put(0, 4, 1);
  StudyResults results = read_results(folder_, members_);
  EXPECT_EQ(inertia_text(results), "");
  put(1, 4, 1, 0.3);
  put(2, 4, 1, 0.3);
  results = read_results(folder_, members_);
  EXPECT_THAT(inertia_text(results),
              StartsWith("2 of 3 members are no slow tests, such as member 1: the peak is not that of"));
}

TEST(StudyTable, QuotesTextsThatHoldCommas) {
  const mpm::TableColumn column{"a", "J/m", "", std::vector<std::string>{"x", "y, z", "say \"so\""}};
  EXPECT_EQ(table_csv({column}), "a_J_per_m\nx\n\"y, z\"\n\"say \"\"so\"\"\"\n");
}

}  // namespace study_results_test
