#include "specimen/convert/photo.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "specimen/convert/smoothing.hpp"
#include "tests/specimen/drawn.hpp"

namespace photo_test {

using specimen::automatic_classes;
using specimen::colour_classes;
using specimen::ColourClasses;
using specimen::Raster;
using specimen::Rgb;
using specimen_test::add_noise;
using specimen_test::cut_with_pores;
using specimen_test::draw_disc;
using specimen_test::grey;
using ::testing::HasSubstr;

ColourClasses automatic(const Raster<Rgb>& picture) {
  return automatic_classes(to_lab(specimen::median_of(picture, 5)), to_lab(picture));
}

TEST(Photo, ClassesRiseInLightness) {
  Raster<Rgb> picture(60, 90, Rgb{200, 200, 200});
  for (int r = 0; r < 60; ++r)
    for (int c = 0; c < 60; ++c) picture(r, c) = c < 30 ? Rgb{90, 60, 60} : Rgb{20, 20, 20};
  const ColourClasses found = colour_classes(to_lab(picture), 3);
  EXPECT_EQ(found.classes(30, 45), 0);
  EXPECT_EQ(found.classes(30, 10), 1);
  EXPECT_EQ(found.classes(30, 80), 2);
  EXPECT_LT(found.centres[0][0], found.centres[1][0]);
}

TEST(Photo, KnowsADrawingByItsFlatColoursUnderNoise) {
  Raster<Rgb> picture(240, 240, Rgb{200, 200, 200});
  draw_disc(picture, 80, 80, 50, Rgb{250, 130, 250});
  draw_disc(picture, 170, 160, 40, Rgb{180, 180, 250});
  add_noise(picture, 6);
  const ColourClasses found = automatic(picture);
  EXPECT_TRUE(found.flat);
  EXPECT_EQ(found.centres.size(), 3U);
  EXPECT_THAT(found.reason, HasSubstr("a drawing in 3 colours"));
  EXPECT_EQ(found.classes(80, 80), found.classes(80, 110));
  EXPECT_NE(found.classes(80, 80), found.classes(170, 160));
}

/// Grey stones and a dark hole with shaded walls in mortar that an indicator has dyed pink; all of it uneven.
Raster<Rgb> indicator_cut() {
  Raster<Rgb> picture(300, 300, Rgb{190, 100, 150});
  std::mt19937_64 random(5);
  for (int i = 0; i < 400; ++i) {
    const double row = static_cast<double>(random() % 300), col = static_cast<double>(random() % 300);
    const auto light = static_cast<std::uint8_t>(random() % 40);
    draw_disc(picture, row, col, 6,
              {static_cast<std::uint8_t>(170 + light), static_cast<std::uint8_t>(85 + light), 140});
  }
  for (const auto& [row, col] : {std::pair(90.0, 90.0), std::pair(200.0, 210.0)})
    for (int i = 0; i < 300; ++i) {
      const double angle = static_cast<double>(random() % 628) / 100,
                   r = std::sqrt(static_cast<double>(random() % 2500));
      const auto light = static_cast<std::uint8_t>(100 + random() % 90);
      draw_disc(picture, row + r * std::sin(angle), col + r * std::cos(angle), 8,
                {light, static_cast<std::uint8_t>(light - 5), static_cast<std::uint8_t>(light - 10)});
    }
  draw_disc(picture, 60, 230, 25, Rgb{140, 92, 95});
  draw_disc(picture, 65, 235, 12, Rgb{25, 15, 15});
  add_noise(picture, 15);
  return picture;
}

TEST(Photo, TellsTheThreePhasesOfACutWithIndicator) {
  const ColourClasses found = automatic(indicator_cut());
  EXPECT_THAT(found.reason, HasSubstr("indicator"));
  ASSERT_EQ(found.phases.size(), found.centres.size());
  const auto phase_at = [&](int row, int col) { return found.phases[found.classes(row, col)]; };
  EXPECT_EQ(phase_at(90, 90), "aggregate");
  EXPECT_EQ(phase_at(200, 210), "aggregate");
  EXPECT_EQ(phase_at(200, 60), "mortar");
  EXPECT_EQ(phase_at(65, 235), "void");
  EXPECT_TRUE(found.dark);
  int walls = 0;
  for (int i = 0; i < 40; ++i) walls += phase_at(40 + i, 214) == "void";
  EXPECT_GT(walls, 20);
}

TEST(Photo, TellsSmoothStonesFromSandOfTheSameMeanColour) {
  Raster<Rgb> picture(240, 240, Rgb{130, 125, 120});
  add_noise(picture, 60);
  draw_disc(picture, 80, 80, 40, Rgb{130, 125, 120});
  draw_disc(picture, 170, 160, 45, Rgb{130, 125, 120});
  const ColourClasses found = automatic(picture);
  ASSERT_EQ(found.centres.size(), 2U);
  EXPECT_EQ(found.classes(80, 80), found.classes(170, 160));
  EXPECT_NE(found.classes(80, 80), found.classes(20, 200));
}

TEST(Photo, SetsApartWhatSwallowsTheLight) {
  Raster<Rgb> picture(200, 200, Rgb{120, 120, 115});
  for (int c = 100; c < 200; ++c)
    for (int r = 0; r < 200; ++r) picture(r, c) = {150, 150, 150};
  add_noise(picture, 60);
  draw_disc(picture, 50, 50, 12, Rgb{20, 20, 20});
  const ColourClasses found = automatic(picture);
  EXPECT_TRUE(found.dark);
  EXPECT_EQ(found.classes(50, 50), 0);
  EXPECT_NE(found.classes(150, 50), 0);
}

TEST(Photo, TakesNoSmoothEdgesForColoursOfADrawing) {
  const ColourClasses found = automatic(cut_with_pores(grey(25), grey(190), grey(120), 12, 6));
  EXPECT_TRUE(found.flat);
  EXPECT_EQ(found.centres.size(), 3U) << found.reason;
  EXPECT_EQ(found.classes(220, 15), 0);
  EXPECT_EQ(found.classes(120, 120), 1);
  EXPECT_EQ(found.classes(60, 70), 2);
}

TEST(Photo, LeavesHolesOutWhereItTellsStonesFromMortar) {
  const ColourClasses found = automatic(cut_with_pores(grey(30), grey(150), grey(190), 24, 25));
  ASSERT_FALSE(found.flat);
  ASSERT_EQ(found.centres.size(), 3U) << found.reason << found.centres[0][0];
  EXPECT_EQ(found.classes(220, 15), 0);
  EXPECT_EQ(found.classes(60, 70), 1);
  EXPECT_EQ(found.classes(150, 160), 1);
  EXPECT_EQ(found.classes(110, 120), 2);
}

TEST(Photo, TakesUnevenLightForNoSecondPhase) {
  Raster<Rgb> picture(240, 240);
  for (int r = 0; r < 240; ++r)
    for (int c = 0; c < 240; ++c) picture(r, c) = grey(90 + (r + c) / 4);
  draw_disc(picture, 120, 60, 14, grey(15));
  add_noise(picture, 15);
  const ColourClasses found = automatic(picture);
  ASSERT_EQ(found.centres.size(), 2U) << found.reason;
  EXPECT_EQ(found.phases, (std::vector<std::string>{"void", "mortar"}));
  EXPECT_EQ(found.classes(120, 60), 0);
  EXPECT_EQ(found.classes(20, 20), 1);
  EXPECT_EQ(found.classes(220, 220), 1);
}

TEST(Photo, SortsTheSamePictureAlikeEveryTime) {
  const Raster<Rgb> picture = indicator_cut();
  EXPECT_EQ(automatic(picture).classes, automatic(picture).classes);
}

}  // namespace photo_test
