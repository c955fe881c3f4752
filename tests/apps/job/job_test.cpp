#include "apps/job/job.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/system/job_pool.hpp"
#include "apps/text/complaint.hpp"

namespace job_test {

/// Specimen from rows of digits (labels), pixels of 1 mm.
specimen::Specimen specimen_of(const std::vector<std::string>& rows) {
  specimen::Specimen result;
  result.itz.mode = specimen::ItzMode::none;
  result.mask.pixel_size = 1e-3;
  result.mask.labels = {static_cast<int>(rows.size()), static_cast<int>(rows.front().size())};
  for (int row = 0; row < result.mask.labels.rows; ++row)
    for (int col = 0; col < result.mask.labels.cols; ++col)
      result.mask.labels(row, col) =
          static_cast<std::uint8_t>(rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(col)] - '0');
  return result;
}

std::string complaint_about(const specimen::Specimen& specimen, const app::Settings& settings) {
  try {
    (void)app::build_scene(specimen, settings);
    return "accepted";
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::data);
    return rejected.what();
  }
}

TEST(BuildScene, KeepsTheTopRowOnTop) {
  const mpm::Scene scene = app::build_scene(specimen_of({"12", "03"}), {});
  EXPECT_EQ(scene.labels(0, 0), 1);
  EXPECT_EQ(scene.labels(0, 1), 2);
  EXPECT_EQ(scene.labels(1, 0), 0);
  EXPECT_EQ(scene.labels(1, 1), 3);
  EXPECT_EQ(scene.pixel_size, 1e-3);
}

TEST(BuildScene, GivesEachLabelItsMaterialByName) {
  app::Settings settings;
  app::phase_named(settings, "fibre").young = 200e9;
  specimen::Specimen specimen = specimen_of({"24", "10"});
  specimen.mask.phases.push_back("fibre");
  const mpm::Scene scene = app::build_scene(specimen, settings);
  ASSERT_EQ(scene.phases.size(), 5u);
  EXPECT_FALSE(scene.phases[0]);
  EXPECT_EQ(scene.phases[1]->young, 40e9);
  EXPECT_EQ(scene.phases[2]->young, 20e9);
  EXPECT_FALSE(scene.phases[3]);  // no pixel of it
  EXPECT_EQ(scene.phases[4]->young, 200e9);
}

TEST(MakeJob, HasNoMoreThreadsThanThereAreCores) {
  app::Settings settings;
  settings.scene.points_per_cell = 2;
  settings.scene.pixel_cells = false;
  settings.scene.threads = 1024;
  const app::Job held = app::make_job(settings, app::Prepared{specimen_of({"22", "22"}), {}, {}});
  EXPECT_EQ(held.scene.threads, app::core_count());
  ASSERT_EQ(held.notes.size(), 1U);
  EXPECT_EQ(held.notes.front().find("solver.threads = 1024 is more than there are cores"), 0U);
  settings.scene.threads = 1;
  EXPECT_TRUE(app::make_job(settings, app::Prepared{specimen_of({"22", "22"}), {}, {}}).notes.empty());
}

TEST(BuildScene, TakesTheRunFromTheSettings) {
  app::Settings settings;
  settings.scene.loading.velocity = 0.3;
  settings.scene.damage.seed = 7;
  settings.scene.cfl = 0.25;
  const mpm::Scene scene = app::build_scene(specimen_of({"22", "22"}), settings);
  EXPECT_EQ(scene.loading.velocity, 0.3);
  EXPECT_EQ(scene.damage.seed, 7u);
  EXPECT_EQ(scene.cfl, 0.25);
}

TEST(BuildScene, RefusesAPhaseWithoutMaterial) {
  specimen::Specimen specimen = specimen_of({"24", "10"});
  specimen.mask.phases.push_back("fibre");
  EXPECT_EQ(complaint_about(specimen, {}),
            "phases.fibre: has no material; the specimen has void, aggregate, mortar and fibre; give young, "
            "poisson and "
            "density in [phases.fibre], or as --fibre.young ...");
}

TEST(BuildScene, RefusesAMaterialWithoutPhase) {
  app::Settings settings;
  app::phase_named(settings, "mortr");
  EXPECT_EQ(
      complaint_about(specimen_of({"22", "22"}), settings),
      "phases.mortr: no such phase; the specimen has void, aggregate, mortar and itz; did you mean mortar?");
}

TEST(BuildScene, RefusesAMaterialOfVoid) {
  app::Settings settings;
  app::phase_named(settings, "void");
  EXPECT_EQ(complaint_about(specimen_of({"22", "22"}), settings),
            "phases.void: a material; void is empty; remove it, or name the phase otherwise");
}

TEST(BuildScene, RingVerticesBecomePointsInThatModeOnly) {
  specimen::Specimen specimen = specimen_of({"22", "22"});
  specimen.rings.push_back({1, {{0.5e-3, 0.5e-3}, {2e-3, 2e-3}, {2.1e-3, 1e-3}}});
  EXPECT_TRUE(app::build_scene(specimen, {}).extra_points.empty());
  specimen.itz.mode = specimen::ItzMode::points;
  const mpm::Scene scene = app::build_scene(specimen, {});
  ASSERT_EQ(scene.extra_points.size(), 2u);  // the third lies outside
  EXPECT_EQ(scene.extra_points[0].x, 0.5e-3);
  EXPECT_EQ(scene.extra_points[0].phase, specimen::phase::itz);
  EXPECT_EQ(scene.phases[3]->young, 12e9);  // needed though no pixel is ITZ
}

TEST(BuildScene, RefusesAnEdgeAtWhichThePlatenTouchesNothing) {
  const std::string cure =
      "; must touch both platens; crop the picture with convert.crop to where the material begins";
  EXPECT_EQ(complaint_about(specimen_of({"00", "00", "22", "22"}), {}),
            "specimen: void along its top edge" + cure);
  EXPECT_EQ(complaint_about(specimen_of({"22", "22", "00", "00"}), {}),
            "specimen: void along its bottom edge" + cure);
  EXPECT_EQ(complaint_about(specimen_of({"00", "02", "20", "00"}), {}),
            "specimen: void along its top edge" + cure);
  app::Settings larger;  // the pixel below reaches the nodes of the edge
  larger.scene.pixel_cells = false;
  larger.scene.points_per_cell = 2;
  EXPECT_EQ(complaint_about(specimen_of({"00", "02", "20", "00"}), larger), "accepted");
}

TEST(BuildScene, RefusesASpecimenInTwoParts) {
  const specimen::Specimen parts = specimen_of({"2222", "2222", "0000", "0000", "2222", "2222"});
  const std::string refusal =
      "specimen: void from side to side, 2 mm below its top edge; must hold together from platen to platen; "
      "look at the phases with mesopix inspect; convert.class_phases says which class is void";
  EXPECT_EQ(complaint_about(parts, {}), refusal);
  app::Settings settings;
  settings.scene.kinematics = mpm::Kinematics::moving;
  EXPECT_EQ(complaint_about(parts, settings), refusal);
  settings.scene.pixel_cells = false;
  settings.scene.points_per_cell = 2;
  settings.scene.loading.direction = mpm::Direction::compression;  // they may still meet
  EXPECT_EQ(complaint_about(parts, settings), "accepted");
  // Cells that share a corner hold together; a cell may be void in part.
  EXPECT_EQ(complaint_about(specimen_of({"0022", "0022", "2200", "2200", "0200", "2200"}), {}), "accepted");
}

// A cell of 2 x 2 pixels has nodes on both sides of a void that is thinner than it.
TEST(BuildScene, RefusesAVoidWithinCells) {
  for (const auto method : {mpm::SolverMethod::explicit_, mpm::SolverMethod::quasi_static}) {
    app::Settings settings;
    settings.scene.method = method;
    settings.scene.pixel_cells = false;
    settings.scene.points_per_cell = 2;
    EXPECT_THAT(complaint_about(specimen_of({"2222", "2222", "2222", "0000", "2222", "2222"}), settings),
                testing::StartsWith("specimen: void from side to side, 3 mm below its top edge"));
    EXPECT_THAT(complaint_about(specimen_of({"2222", "2222", "2200", "0022", "2222", "2222"}), settings),
                "accepted");
  }
}

TEST(BuildScene, RefusesPartsThatCannotMeet) {
  app::Settings settings;
  settings.scene.kinematics = mpm::Kinematics::moving;
  settings.scene.loading.direction = mpm::Direction::compression;
  settings.scene.pixel_cells = false;
  settings.scene.points_per_cell = 2;
  const specimen::Specimen far =
      specimen_of({"2222", "2222", "0000", "0000", "0000", "0000", "2222", "2222"});
  EXPECT_THAT(complaint_about(far, settings), testing::StartsWith("specimen: void from side to side, 2 mm"));
  settings.scene.loading.stop_strain = 0.5;
  EXPECT_EQ(complaint_about(far, settings), "accepted");
  const app::Job job = app::make_job(settings, {far, {}, {}});
  ASSERT_EQ(job.notes.size(), 1U);
  EXPECT_EQ(
      job.notes[0],
      "the specimen is in parts, with void from side to side, 2 mm below its top edge: nothing is carried "
      "from platen to platen until they meet; the least gap is 4 mm, and the platen moves by 4 mm");
}

TEST(BuildScene, LetsASpecimenWithoutPlatensFlyAnywhereButNotRest) {
  app::Settings settings;
  settings.scene.loading.direction = mpm::Direction::none;
  EXPECT_EQ(complaint_about(specimen_of({"00", "00", "22", "22"}), settings),
            "loading.initial_velocity_y: 0 m/s; without platens a specimen at rest stays at rest; give "
            "loading.initial_velocity_x or loading.initial_velocity_y");
  settings.scene.loading.initial_velocity_x = -20;
  EXPECT_EQ(complaint_about(specimen_of({"00", "00", "22", "22"}), settings), "accepted");
}

TEST(CropToCells, CutsAtTheTopAndAtTheRight) {
  specimen::Specimen specimen = specimen_of({"333", "122", "212"});
  const auto notes = app::crop_to_cells(specimen, 2);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "the specimen was cropped from 3 x 3 to 2 x 2 pixels, at its top and right edges, to whole cells "
            "of 2 x 2 "
            "pixels");
  EXPECT_EQ(specimen.mask.labels.data, (std::vector<std::uint8_t>{1, 2, 2, 1}));
}

TEST(CropToCells, LeavesWholeCellsAlone) {
  specimen::Specimen specimen = specimen_of({"33", "12"});
  const auto before = specimen.mask;
  EXPECT_TRUE(app::crop_to_cells(specimen, 2).empty());
  EXPECT_EQ(specimen.mask, before);
}

TEST(CropToCells, RefusesASpecimenSmallerThanACell) {
  specimen::Specimen specimen = specimen_of({"33", "12"});
  try {
    (void)app::crop_to_cells(specimen, 4);
    FAIL();
  } catch (const app::Rejected& rejected) {
    EXPECT_STREQ(rejected.what(),
                 "solver.cell: 4 x 4; the specimen has only 2 x 2 pixels; use smaller pixels");
  }
}

}  // namespace job_test
