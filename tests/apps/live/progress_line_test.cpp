#include "apps/live/progress_line.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace progress_line_test {

mpm::HistoryRow some_row() {
  mpm::HistoryRow row;
  row.strain = 168e-6;
  row.stress = 3.412e6;
  row.tension_failures = 1230;
  row.shear_failures = 4;
  return row;
}

TEST(ProgressText, TellsStrainStressFailuresAndTimeLeft) {
  const mpm::HistoryRow row = some_row();
  EXPECT_EQ(app::progress_text({}, {row, 0.42, 8.4}),
            " 42 %   strain 168e-6   stress 3.41 MPa   1234 failed   12 s left");
  EXPECT_EQ(app::progress_text({}, {row, 0.01, 100}),
            "  1 %   strain 168e-6   stress 3.41 MPa   1234 failed   165 min left");
  EXPECT_EQ(app::progress_text({}, {row, 0, 0}), "  0 %   strain 168e-6   stress 3.41 MPa   1234 failed");
}

TEST(ProgressText, TellsLargeStrainsInPercent) {
  mpm::HistoryRow row = some_row();
  row.strain = 0.0231;
  EXPECT_EQ(app::progress_text({}, {row, 0, 0}), "  0 %   strain 2.31 %   stress 3.41 MPa   1234 failed");
}

TEST(ProgressText, SaysThatItIsNominalWithoutPlatens) {
  mpm::Scene scene;
  scene.loading.direction = mpm::Direction::none;
  const mpm::HistoryRow row = some_row();
  EXPECT_EQ(app::progress_text(scene, {row, 0, 0}),
            "  0 %   nominal strain 168e-6   stress on the walls 3.41 MPa   1234 failed");
}

TEST(ProgressLine, DrawsOverItselfAtMostTenTimesASecondAndWipesItselfAway) {
  const mpm::HistoryRow row = some_row();
  const mpm::Scene scene;
  std::ostringstream terminal;
  {
    app::ProgressLine line(terminal, scene, true);
    line.show({row, 0.1, 1.00});
    line.show({row, 0.2, 1.05});
    line.show({row, 0.3, 1.11});
  }
  const std::string drawn = terminal.str();
  EXPECT_NE(drawn.find(" 10 %"), std::string::npos);
  EXPECT_EQ(drawn.find(" 20 %"), std::string::npos);
  EXPECT_NE(drawn.find(" 30 %"), std::string::npos);
  EXPECT_EQ(drawn.find('\n'), std::string::npos);
  EXPECT_EQ(drawn.substr(drawn.size() - 4), "\r\x1b[K");
}

TEST(ProgressLine, IsSilentWhereItIsNotWanted) {
  const mpm::HistoryRow row = some_row();
  const mpm::Scene scene;
  std::ostringstream terminal;
  {
    app::ProgressLine line(terminal, scene, false);
    line.show({row, 0.1, 1});
  }
  EXPECT_EQ(terminal.str(), "");
}

}  // namespace progress_line_test
