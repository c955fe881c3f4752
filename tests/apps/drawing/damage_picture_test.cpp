#include "apps/drawing/damage_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "specimen/picture/picture.hpp"
#include "tests/apps/fake_run.hpp"

namespace damage_picture_test {

using namespace output;
using specimen::Raster;
using specimen::Rgb;

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

}  // namespace damage_picture_test
