#include "apps/study/study_members.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/apps/small_study.hpp"

namespace study_members_test {

using namespace app;
using testing::HasSubstr;
using testing::Not;

constexpr const char* two_by_two = "seeds = [3, 8]\n[vary]\n\"solver.cfl\" = [0.5, 0.8]\n";

TEST(StudyMembers, AllPointsWithTheFirstSeedComeFirst) {
  const test::TemporaryFolder folder;
  const Study study = test::small_study(folder, two_by_two);
  const std::vector<Member> members = list_members(study);
  ASSERT_EQ(members.size(), 4U);
  EXPECT_EQ(name_of(study, members[1]), "member 1 (solver.cfl = 0.8, seed 3)");
  EXPECT_EQ(name_of(study, members[2]), "member 2 (solver.cfl = 0.5, seed 8)");
  EXPECT_EQ(members[3].point, 1U);
  const Settings settings = *members[3].settings;
  EXPECT_EQ(settings.scene.cfl, 0.8);
  EXPECT_EQ(settings.scene.damage.seed, 8U);
  EXPECT_EQ(settings.packing.seed, 8U);
  EXPECT_EQ(settings.scene.threads, 1);
}

TEST(StudyMembers, SeedsOfOneTableLeaveTheOtherAsItIs) {
  const test::TemporaryFolder folder;
  const Study study = test::small_study(folder, "seeds = [3, 8]\nseed_of = [\"damage\"]\n");
  const Settings settings = *list_members(study)[1].settings;
  EXPECT_EQ(settings.scene.damage.seed, 8U);
  EXPECT_EQ(settings.packing.seed, 1U);
}

TEST(StudyMembers, ParametersThatAreJoinedShareTheirValue) {
  const test::TemporaryFolder folder;
  const Study study =
      test::small_study(folder, "[vary]\n\"generate.width + generate.height\" = [\"20 mm\"]\n");
  const Settings settings = *list_members(study).front().settings;
  EXPECT_EQ(settings.packing.width, 0.02);
  EXPECT_EQ(settings.packing.height, 0.02);
}

TEST(StudyMembers, IdsAreThoseOfWhatTheResultDependsOn) {
  const test::TemporaryFolder folder;
  const std::vector<Member> members = list_members(test::small_study(folder, two_by_two));
  std::set<std::string> ids;
  for (const Member& member : members) ids.insert(member.id);
  EXPECT_EQ(ids.size(), 4U);
  EXPECT_EQ(ids.begin()->size(), 16U);
  const std::vector<Member> more = list_members(
      test::small_study(folder, "title = \"T\"\nseeds = [1, 3]\n[vary]\n\"solver.cfl\" = [0.9, 0.5, 0.8]\n"));
  EXPECT_EQ(more[4].id, members[0].id);  // wherever it stands
  EXPECT_EQ(more[5].id, members[1].id);
}

TEST(StudyMembers, RefusesAMemberThatIsNotValidAndNamesIt) {
  const test::TemporaryFolder folder;
  const Study study =
      test::small_study(folder, "[vary]\n\"solver.cfl\" = [0.5]\n\"motion.flip_ratio\" = [1, 0.9]\n");
  try {
    (void)list_members(study);
    FAIL();
  } catch (const Rejected& rejected) {
    EXPECT_EQ(rejected.code, Exit::data);
    EXPECT_THAT(
        app::text(rejected.complaints.front()),
        testing::AllOf(HasSubstr("study.toml:4:23: vary.motion.flip_ratio: 1, in member 0 (solver.cfl = 0.5, "
                                 "motion.flip_ratio = 1); has an effect with solver.kinematics"),
                       HasSubstr("remove it")));
  }
}

TEST(StudyMembers, RefusesTheSameRunTwice) {
  const test::TemporaryFolder folder;
  const Study study = test::small_study(folder, "[vary]\n\"solver.threads\" = [1, 2]\n");
  try {
    (void)list_members(study);
    FAIL();
  } catch (const Rejected& rejected) {
    EXPECT_THAT(
        app::text(rejected.complaints.front()),
        HasSubstr("study: the same run as member 0, in member 1 (solver.threads = 2); members must differ"));
  }
}

TEST(StudyMembers, RefusesSeedsThatHaveNoEffect) {
  const test::TemporaryFolder folder;
  test::write_small_study(folder / "", "seeds = 2\nseed_of = [\"generate\"]\n");
  test::write_text(folder / "scene.toml",
                   "ellipses = [{x = \"20 mm\", y = \"20 mm\", a = \"5 mm\", b = \"5 mm\"}]\n");
  try {
    (void)list_members(read_study(folder / "study.toml"));
    FAIL();
  } catch (const Rejected& rejected) {
    EXPECT_THAT(
        app::text(rejected.complaints.front()),
        HasSubstr("study.toml:3:11: seed_of: \"generate\", in member 0 (seed 1); has no effect on given "
                  "ellipses; remove it"));
  }
}

TEST(StudyMembers, RefusesAggregatesThatNoSpecimenHas) {
  const test::TemporaryFolder folder;
  const Study study = test::small_study(folder, "[vary]\n\"generate.d_min\" = [\"4 mm\", \"9 mm\"]\n");
  try {
    (void)list_members(study);
    FAIL();
  } catch (const Rejected& rejected) {
    EXPECT_THAT(app::text(rejected.complaints.front()), HasSubstr("in member 1 (generate.d_min = 9 mm)"));
  }
}

TEST(StudyMembers, IdsComeFromValuesAndNotFromTheirWording) {
  const test::TemporaryFolder folder;
  const Study study = test::small_study(folder, two_by_two);
  const std::vector<Member> members = list_members(study);
  const Settings& settings = *members[2].settings;
  EXPECT_EQ(members[2].id, identity_of(settings));
  EXPECT_THAT(identity_text(settings), Not(HasSubstr("#"))) << "no help";
  EXPECT_THAT(identity_text(settings), HasSubstr("\ngenerate.width = 0.016\n"));
  Settings other = settings;
  other.title = "T";
  EXPECT_EQ(identity_of(other), members[2].id);
  other.scene.loading.velocity = std::nextafter(other.scene.loading.velocity, 1);
  EXPECT_NE(identity_of(other), members[2].id);
}

TEST(StudyMembers, ThoseOfFewerSeedsStayAsTheyAreWhenItGrows) {
  const test::TemporaryFolder folder;
  Study study = test::small_study(folder, two_by_two);
  const std::vector<Member> before = list_members(study);
  study.plan.seeds.push_back(9);
  const std::vector<Member> grown = list_members(study, before), anew = list_members(study);
  ASSERT_EQ(grown.size(), 6U);
  EXPECT_EQ(grown[3].settings, before[3].settings);
  for (std::size_t i = 0; i < grown.size(); ++i) {
    EXPECT_EQ(grown[i].id, anew[i].id);
    EXPECT_EQ(name_of(study, grown[i]), name_of(study, anew[i]));
  }
}

TEST(StudyMembers, ScenesNameNoFolders) {
  const test::TemporaryFolder folder;
  Settings settings;
  settings.specimen.picture = folder / "cut.png";
  settings.title = "T";
  EXPECT_THAT(member_scene(settings), HasSubstr("picture = \"cut.png\""));
  EXPECT_THAT(member_scene(settings), Not(HasSubstr("title")));
}

}  // namespace study_members_test
