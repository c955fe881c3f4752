#include "apps/drawing/damage_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace damage_stages_test {

using namespace output;
using testing::ElementsAre;

mpm::Result run_to(double share, double peak_strain = 1e-4) {
  mpm::Result result;
  result.peak_strain = peak_strain;
  result.history.push_back({});
  result.history.push_back({.strain = share * peak_strain});
  return result;
}

std::vector<int> percents(const DamageStages& stages) {
  std::vector<int> list;
  for (const DamageStage& stage : stages.drawn) list.push_back(stage.percent);
  return list;
}

TEST(DamageStages, AreAllDrawnForALongRun) {
  const DamageStages stages = damage_stages(run_to(2));
  EXPECT_THAT(percents(stages), ElementsAre(25, 50, 75, 100, 125, 150));
  EXPECT_TRUE(stages.missing.empty());
  EXPECT_EQ(missing_note(stages), "");
  EXPECT_DOUBLE_EQ(stages.drawn[0].strain, 0.25e-4);
}

TEST(DamageStages, LeaveOutWhatTheRunDidNotReachAndSaySo) {
  const DamageStages stages = damage_stages(run_to(1.239));
  EXPECT_THAT(percents(stages), ElementsAre(25, 50, 75, 100));
  EXPECT_THAT(stages.missing, ElementsAre(125, 150));
  EXPECT_EQ(missing_note(stages),
            "The run ended at 123 % of the peak strain: there is no picture of damage at 125 % and 150 %.");
}

TEST(DamageStages, ForgiveRoundOffAtTheLastStrain) {
  EXPECT_THAT(percents(damage_stages(run_to(1.5 * (1 - 1e-12)))), ElementsAre(25, 50, 75, 100, 125, 150));
  EXPECT_EQ(damage_stages(run_to(1.499)).missing.size(), 1U);
  EXPECT_THAT(percents(damage_stages(run_to(1))), ElementsAre(25, 50, 75, 100));
}

TEST(DamageStages, AreNoneWithoutAPeak) {
  const DamageStages stages = damage_stages(mpm::Result{});
  EXPECT_TRUE(stages.drawn.empty());
  EXPECT_EQ(missing_note(stages), "The run has no peak stress, so no picture of damage was drawn.");
}

TEST(DamageStages, CountFailuresUpToTheirStrain) {
  mpm::Result result = run_to(2);
  const float nan_f = std::numeric_limits<float>::quiet_NaN();
  result.failure_strain.resize(1, 5);
  result.failure_strain << 0.2e-4F, 0.6e-4F, 0.7e-4F, 1.1e-4F, nan_f;
  result.failure_mode.resize(1, 5);
  result.failure_mode << 1, 1, 2, 1, 0;
  result.crush_strain.resize(1, 5);
  result.crush_strain << 1.2e-4F, nan_f, nan_f, nan_f, nan_f;
  const DamageStages stages = damage_stages(result);
  std::vector<std::int64_t> tension, shear;
  for (const DamageStage& stage : stages.drawn) {
    tension.push_back(stage.tension);
    shear.push_back(stage.shear);
  }
  EXPECT_THAT(tension, ElementsAre(1, 1, 2, 2, 3, 3));
  EXPECT_THAT(shear, ElementsAre(0, 0, 1, 1, 2, 2));
}

TEST(PictureName, HasThreeFigures) {
  EXPECT_EQ(picture_name(25, false), "damage_025.png");
  EXPECT_EQ(picture_name(150, true), "damage_150_colour.png");
}

}  // namespace damage_stages_test
