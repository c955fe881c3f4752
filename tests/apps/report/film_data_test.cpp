#include "apps/report/report_data.hpp"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include "tests/apps/fake_run.hpp"

namespace film_data_test {

using output::film_data;
using output::has_film;

TEST(FilmData, CarriesWhatThePixelsAre) {
  const FakeRun run = tension_run(60);
  ASSERT_TRUE(has_film(run.record()));
  const auto film = film_data(run.record());
  EXPECT_EQ(film["rows"], 60);
  EXPECT_EQ(film["cols"], 60);
  EXPECT_DOUBLE_EQ(film["pixel_mm"], 2.5);
  EXPECT_EQ(film["phases"].size(), run.specimen.mask.phases.size());
  EXPECT_TRUE(film["phases"][0]["tensile_MPa"].is_null());  // voids
  EXPECT_DOUBLE_EQ(film["phases"][2]["tensile_MPa"], 1e-6 * run.scene.phases[2]->tensile_scale);
  EXPECT_TRUE(film["crush"].is_null());
  EXPECT_FALSE(film["strength"].is_null());
}

TEST(FilmData, HasCrushingWithCrackClosure) {
  EXPECT_FALSE(film_data(compression_run(60).record())["crush"].is_null());
}

TEST(FilmData, StrengthsAreLeftOutOfLargePictures) {
  const auto film = film_data(tension_run(720).record());  // 518,400 pixels
  EXPECT_TRUE(film["strength"].is_null());
  EXPECT_FALSE(film["failure"].is_null());
}

TEST(FilmData, ARunThatNeverBeganHasNone) { EXPECT_FALSE(has_film(still_run({"12", "32"}).record())); }

}  // namespace film_data_test
