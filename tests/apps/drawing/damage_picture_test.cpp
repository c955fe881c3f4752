#include "apps/drawing/damage_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "specimen/picture/picture.hpp"
#include "tests/apps/drawn.hpp"
#include "tests/apps/fake_run.hpp"

namespace damage_picture_test {

using namespace output;
using output::Drawing;
using output::Words;
using specimen::Raster;
using specimen::Rgb;
using test::says;
using testing::ElementsAre;

constexpr float nan_f = std::numeric_limits<float>::quiet_NaN();

Raster<Rgb> grey_damage(const FakeRun& run, double strain) {
  return damage_picture(run.specimen.mask, run.result, strain, grey_palette());
}

TEST(DamagePicture, ShowsThePhasesBeforeAnythingFails) {
  const FakeRun run = still_run({"12", "30"});
  const Palette palette = grey_palette();
  const Raster<Rgb> picture = grey_damage(run, 1);
  EXPECT_EQ(picture(0, 0), (Rgb{255, 255, 255}));
  EXPECT_EQ(picture(0, 1), palette.phases[specimen::phase::mortar]);
  EXPECT_EQ(picture(1, 0), palette.phases[specimen::phase::itz]);
  EXPECT_EQ(picture(1, 1), palette.phases[specimen::phase::void_]);
}

TEST(DamagePicture, HasTheTopRowOnTop) {
  FakeRun run = still_run({"22", "22", "22"});
  run.result.failure_strain(0, 1) = 1e-4F;
  run.result.failure_mode(0, 1) = 1;
  run.result.failure_strain(2, 0) = 1e-4F;
  run.result.failure_mode(2, 0) = 2;
  const Palette palette = grey_palette();
  Raster<Rgb> expected(3, 2, palette.phases[2]);
  expected(0, 1) = palette.tension;
  expected(2, 0) = palette.shear;
  EXPECT_EQ(grey_damage(run, 1e-4), expected);
}

TEST(DamagePicture, ShowsAFailureFromItsVeryStrainOn) {
  FakeRun run = still_run({"2"});
  const double strain = 1e-4 / 3;  // no 32-bit number
  run.result.failure_strain(0, 0) = static_cast<float>(strain);
  run.result.failure_mode(0, 0) = 1;
  EXPECT_EQ(grey_damage(run, 0.999 * strain)(0, 0), grey_palette().phases[2]);
  EXPECT_EQ(grey_damage(run, strain)(0, 0), grey_palette().tension);
}

TEST(DamagePicture, ShowsACrackedPointAsShearOnceItIsCrushed) {
  FakeRun run = still_run({"2"});
  run.result.crush_strain.setConstant(1, 1, 3e-4F);
  run.result.failure_strain(0, 0) = 1e-4F;
  run.result.failure_mode(0, 0) = 1;
  EXPECT_EQ(grey_damage(run, 2e-4)(0, 0), grey_palette().tension);
  EXPECT_EQ(grey_damage(run, 4e-4)(0, 0), grey_palette().shear);
  run.result.crush_strain(0, 0) = nan_f;
  EXPECT_EQ(grey_damage(run, 4e-4)(0, 0), grey_palette().tension);
}

int lightness(Rgb colour) { return (299 * colour.r + 587 * colour.g + 114 * colour.b) / 1000; }

TEST(Palettes, SetFailuresApartFromEveryPhaseByLightnessAlone) {
  for (const Palette& palette : {grey_palette(), colour_palette()}) {
    EXPECT_GE(std::abs(lightness(palette.tension) - lightness(palette.shear)), 40);
    for (int label = 0; label < 256; ++label) {
      const int phase = lightness(palette.phases[static_cast<std::size_t>(label)]);
      EXPECT_GE(phase - lightness(palette.shear), 40) << label;
      EXPECT_GE(phase - lightness(palette.tension), 40) << label;
    }
  }
}

TEST(Palettes, HaveAGreyForEachFixedPhase) {
  std::set<int> greys;
  for (std::size_t label = 0; label < 4; ++label) {
    const Rgb colour = grey_palette().phases[label];
    EXPECT_TRUE(colour.r == colour.g && colour.g == colour.b);
    greys.insert(colour.r);
  }
  EXPECT_EQ(greys.size(), 4U);
}

TEST(Palettes, FollowThePhaseColoursOfThePreview) {
  for (const std::uint8_t label : {1, 2, 3, 7}) {
    const Rgb pale = colour_palette().phases[label], full = specimen::phase_colour(label);
    EXPECT_NEAR(pale.r, (255 + full.r) / 2, 1);
    EXPECT_NEAR(pale.b, (255 + full.b) / 2, 1);
  }
}

Drawing drawing_of(const FakeRun& run, double strain) {
  return output::damage_drawing(run.specimen.mask, run.result, strain, output::grey_palette(),
                                "at some strain");
}

TEST(DamageDrawing, NamesWhatIsInIt) {
  const FakeRun run = tension_run(60);
  const Drawing before = drawing_of(run, 0);
  EXPECT_FALSE(says(before, "failed in tension"));
  EXPECT_TRUE(says(before, "mortar"));
  EXPECT_TRUE(says(before, "at some strain"));
  const Drawing after = drawing_of(run, run.result.history.back().strain);
  EXPECT_TRUE(says(after, "failed in tension"));
  EXPECT_EQ(says(after, "failed in shear"), (run.result.failure_mode == std::uint8_t{2}).any());
}

TEST(DamageDrawing, TheScaleBarIsAsLongAsItSays) {
  const FakeRun run = tension_run(60);  // 150 mm on 480 px
  const Drawing drawing = drawing_of(run, 0);
  ASSERT_TRUE(says(drawing, "20 mm"));
  for (const output::Shape& shape : drawing.shapes) {
    const auto* stroke = std::get_if<output::Stroke>(&shape);
    if (stroke == nullptr || stroke->places.size() != 2) continue;
    EXPECT_NEAR(stroke->places[1].x - stroke->places[0].x, 480 * 20.0 / 150, 1e-9);
  }
}

TEST(DamageDrawing, HoldsAllThatItDraws) {
  const Drawing drawing = drawing_of(compression_run(60), 0);
  for (const output::Shape& shape : drawing.shapes)
    if (const Words* words = std::get_if<Words>(&shape)) {
      EXPECT_LE(words->at.y, drawing.height);
      EXPECT_LE(words->at.x, drawing.width);
    }
}

/// Its stress falls again at the strain of the peak, or `left` of it is left at the end.
mpm::Result run_to(double share, double peak_strain = 1e-4, double left = 0.5) {
  mpm::Result result;
  result.peak_stress = 1e6;
  result.peak_strain = peak_strain;
  result.history.push_back({});
  result.history.push_back({.strain = peak_strain, .stress = 1e6});
  result.history.push_back({.strain = share * peak_strain, .stress = left * 1e6});
  return result;
}

TEST(DamageStages, AreSharesOfNoPeakWhereThereIsNone) {
  EXPECT_TRUE(damage_stages(run_to(1.1)).of_peak);
  const DamageStages stages = damage_stages(run_to(1.1, 1e-4, 0.97));
  EXPECT_FALSE(stages.of_peak);
  EXPECT_EQ(
      missing_note(stages),
      "The run ended at 110 % of the strain at the largest stress, which is no peak: there is no picture "
      "of damage at 125 % and 150 %.");
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

TEST(DamageStages, AreNoneWithoutAnyStress) {
  const DamageStages stages = damage_stages(mpm::Result{});
  EXPECT_TRUE(stages.drawn.empty());
  EXPECT_EQ(missing_note(stages), "No stress rose above 0, so no picture of damage was drawn.");
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

}  // namespace damage_picture_test
