#include "apps/reproduce/trial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/text/complaint.hpp"
#include "tests/apps/reproduce/fake_results.hpp"
#include "tests/libmpm/mean_stress.hpp"

namespace trial_test {

using namespace app::reproduce;
using testing::HasSubstr;

/// 10 mm with pixels of 1 mm, for a moment.
Trial tiny(const std::string& scene = "tension") {
  return {scene,
          {{"generate.width", "12 mm"},
           {"generate.height", "12 mm"},
           {"generate.pixel_size", "1 mm"},
           {"generate.d_min", "3 mm"},
           {"generate.d_max", "6 mm"},
           {"generate.fraction", "30 %"}},
          false};
}

TEST(Trial, EveryScenePassesTheSchema) {
  ASSERT_FALSE(paper_scenes().empty());
  for (const PaperScene& scene : paper_scenes())
    EXPECT_NO_THROW((void)settings_of({scene.name, {}, false})) << scene.name;
}

TEST(Trial, SettingsComeOnTopOfTheScene) {
  const app::Settings settings =
      settings_of({"tension", {{"damage.seed", "7"}, {"loading.velocity", "0.1 m/s"}}, false});
  EXPECT_EQ(settings.scene.damage.seed, 7U);
  EXPECT_EQ(settings.scene.loading.velocity, 0.1);
  EXPECT_EQ(settings.packing.width, 0.150);
}

TEST(Trial, OfOneKeyTheLastSettingHolds) {
  const Trial twice{"tension", {{"damage.seed", "7"}, {"damage.seed", "8"}}, false};
  EXPECT_EQ(settings_of(twice).scene.damage.seed, 8U);
  EXPECT_EQ(name_of(twice), name_of({"tension", {{"damage.seed", "8"}}, true}));
  EXPECT_EQ(name_of(twice), "tension damage.seed=8");
}

TEST(Trial, RefusesWhatTheSchemaRefuses) {
  EXPECT_THROW((void)settings_of({"tension", {{"damage.sed", "7"}}, false}), app::Rejected);
  EXPECT_THROW((void)settings_of({"tension", {{"loading.velocity", "7"}}, false}), app::Rejected);
}

TEST(Trial, TellsHowToRunItAlone) {
  EXPECT_EQ(
      command_of({"tension", {{"damage.seed", "2"}, {"loading.velocity", "0.1 m/s"}}, false}),
      "mesopix simulate data/paper/tension.toml --set damage.seed=2 --set \"loading.velocity=0.1 m/s\"");
}

TEST(Trial, RunsAndForgetsItsMapsUnlessTheyAreKept) {
  const auto go_on = [] { return true; };
  Trial trial = tiny();
  const TrialResult lean = run_trial(trial, go_on);
  EXPECT_TRUE(lean.done);
  EXPECT_GT(lean.result.peak_stress, 0);
  EXPECT_EQ(lean.result.failure_strain.size(), 0);
  EXPECT_TRUE(lean.specimen.mask.labels.empty());
  trial.keep_maps = true;
  const TrialResult whole = run_trial(trial, go_on);
  EXPECT_EQ(whole.result.peak_stress, lean.result.peak_stress);
  EXPECT_EQ(whole.result.failure_strain.size(), 144);
  EXPECT_EQ(whole.specimen.mask.labels.size(), 144U);
  EXPECT_EQ(whole.result.threads, 1);
}

TEST(Trial, IsNotDoneWhenItIsInterrupted) {
  EXPECT_FALSE(run_trial(tiny(), [] { return false; }).done);
}

// The paper's tension test on coarse pixels, up to its first hundred failures: points that move, with any
// shape function, follow the small-strain solver.
TEST(Trial, PointsThatMoveFollowSmallStrain) {
  Trial trial{
      "tension",
      {{"generate.pixel_size", "1.5 mm"}, {"loading.velocity", "0.1 m/s"}, {"loading.stop_strain", "6e-5"}},
      false};
  const mpm::Result small = run_trial(trial, [] { return true; }).result;
  double hundred = 0;
  for (const auto& row : small.history)
    if (row.tension_failures <= 100) hundred = row.strain;
  ASSERT_LT(hundred, small.history.back().strain) << "more than a hundred fail";
  for (const char* shape : {"linear", "gimp", "bspline"}) {
    trial.settings.resize(3);
    trial.settings.insert(trial.settings.end(), {{"solver.kinematics", "moving"}, {"motion.shape", shape}});
    const mpm::Result moving = run_trial(trial, [] { return true; }).result;
    for (int i = 0; i < 20; ++i) {
      const double from = i * hundred / 20;
      const double to = (i + 1) * hundred / 20;
      EXPECT_NEAR(samples::mean_stress(moving, from, to), samples::mean_stress(small, from, to),
                  0.01 * small.peak_stress)
          << shape << ", " << i;
    }
  }
}

TEST(TrialResults, KeepMapsWhenOneOfTwoFiguresWantsThem) {
  TrialResults outcomes;
  Trial trial = tiny();
  outcomes.expect(trial);
  EXPECT_FALSE(outcomes.has(trial));
  trial.keep_maps = true;
  outcomes.expect(trial);
  trial.keep_maps = false;
  outcomes.expect(trial);
  ASSERT_EQ(outcomes.entries().size(), 1U);
  EXPECT_TRUE(outcomes.entries().front().trial.keep_maps);
}

TEST(TrialResults, StayInTheOrderInWhichTheyWereAskedFor) {
  TrialResults outcomes;
  for (const char* seed : {"9", "1", "5", "9"}) outcomes.expect({"tension", {{"damage.seed", seed}}, false});
  ASSERT_EQ(outcomes.entries().size(), 3U);
  EXPECT_EQ(name_of(outcomes.entries()[0].trial), "tension damage.seed=9");
  EXPECT_EQ(name_of(outcomes.entries()[2].trial), "tension damage.seed=5");
}

TEST(TrialResults, KnowWhatIsDone) {
  TrialResults outcomes;
  test::put(outcomes, tiny(), test::triangle(1e6, 1e-4));
  EXPECT_TRUE(outcomes.has(tiny()));
  EXPECT_EQ(outcomes.of(tiny()).result.peak_stress, 1e6);
  EXPECT_FALSE(outcomes.has(tiny("compression")));
}

}  // namespace trial_test
