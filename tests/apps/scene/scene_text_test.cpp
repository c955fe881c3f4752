#include "apps/scene/scene_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/scene/scene_file.hpp"
#include "apps/settings/schema.hpp"
#include "apps/text/complaint.hpp"

namespace scene_text_test {

using app::scene_differences;
using testing::HasSubstr;
using testing::Not;

/// Write the settings and read them again, as if the text lay in `folder`.
app::Settings there_and_back(const app::Settings& settings, const std::string& folder) {
  const std::string toml = app::scene_text(settings, app::Extent::whole, folder);
  return app::resolve(app::parse_scene(toml, folder + "/scene.toml"), {}).settings;
}

void expect_same(const app::Settings& first, const app::Settings& second) {
  for (const app::Field& field : app::fields())
    if (field.form.kind != app::Kind::path) {
      EXPECT_EQ(field.get(first), field.get(second)) << field.key;
    }
  ASSERT_EQ(first.phases.size(), second.phases.size());
  for (std::size_t i = 0; i < first.phases.size(); ++i) {
    EXPECT_EQ(first.phases[i].name, second.phases[i].name);
    for (const app::PhaseField& property : app::phase_fields())
      EXPECT_EQ(property.get(first.phases[i]), property.get(second.phases[i]))
          << first.phases[i].name << property.key;
  }
  EXPECT_EQ(first.specimen.ellipse_list, second.specimen.ellipse_list);
}

app::Settings unusual_settings() {
  app::Settings settings;
  settings.scene.loading.velocity = 1.0 / 3;
  settings.scene.loading.stop_drop = 0.1 + 0.2;
  settings.scene.loading.ramp_time = 1e-4 / 7;
  settings.scene.damage.seed = 1234567890123;
  settings.scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  settings.scene.plane = mpm::Plane::stress;
  settings.scene.precision = mpm::Precision::single;
  settings.title = "quotes \" and \\ and\nlines";
  settings.phases[1].friction_angle = 0.9;
  mpm::Phase& fibre = app::phase_named(settings, "fibre-2");
  fibre.young = 200e9 / 3;
  fibre.poisson = 0.3;
  fibre.density = 7850;
  return settings;
}

TEST(SceneText, ReadsBackToTheSameSettings) {
  expect_same(there_and_back({}, "out"), {});
  const app::Settings settings = unusual_settings();
  expect_same(there_and_back(settings, "out"), settings);
}

app::Settings flying_settings() {
  app::Settings settings;
  mpm::Scene& scene = settings.scene;
  scene.kinematics = mpm::Kinematics::moving;
  scene.loading.direction = mpm::Direction::none;
  scene.loading.initial_velocity_x = 1.0 / 3;
  scene.loading.initial_velocity_y = -20.5;
  scene.loading.duration = 1e-3 / 7;
  scene.motion.shape = mpm::Shape::bspline;
  scene.motion.scheme = mpm::Scheme::usf;
  scene.motion.transfer = mpm::Transfer::apic;
  scene.motion.margin = 0;
  scene.motion.left = mpm::Edge::symmetry;
  scene.motion.right = mpm::Edge::open;
  scene.motion.bottom = mpm::Edge::smooth_wall;
  scene.motion.top = mpm::Edge::rough_wall;
  return settings;
}

app::Settings handed_over_settings() {
  app::Settings settings;
  mpm::Scene& scene = settings.scene;
  scene.kinematics = mpm::Kinematics::automatic;
  scene.loading.direction = mpm::Direction::compression;
  scene.loading.separation = true;
  scene.motion.flip_ratio = 0.99;
  scene.motion.margin = 0.1 / 3;
  scene.handover.strain = 0.1 / 7;
  scene.handover.displacement = 0.3;
  return settings;
}

TEST(SceneText, KeepsEverySettingOfMovingPoints) {
  for (const app::Settings& settings : {flying_settings(), handed_over_settings()})
    expect_same(there_and_back(settings, "out"), settings);
}

TEST(SceneText, IsTheSameWhenWrittenAgain) {
  const app::Settings settings = unusual_settings();
  EXPECT_EQ(app::scene_text(settings, app::Extent::whole, "out"),
            app::scene_text(there_and_back(settings, "out"), app::Extent::whole, "out"));
}

TEST(SceneText, KeepsEverySettingOfEverySource) {
  app::Settings classes;
  classes.grading.classes = {{8e-3, 16e-3, 0.7}, {4e-3, 8e-3, 0.3}};
  classes.packing.gap = 1e-3 / 3;
  expect_same(there_and_back(classes, "out"), classes);
  app::Settings ellipses;
  ellipses.specimen.ellipse_list = {{0.02, 0.03, 0.01, 0.005, 0.3}, {0.05, 1.0 / 30, 0.01, 0.005, 0}};
  ellipses.packing.width = 0.075;
  expect_same(there_and_back(ellipses, "out"), ellipses);
  app::Settings picture;
  picture.specimen.picture = "pictures/a.png";
  picture.specimen.sha256 = "abc";
  picture.convert.width = 0.2;
  picture.convert.crop = {1, 2, 30, 40};
  picture.convert.thresholds = {80.5, 160};
  picture.convert.label_phases = {{0, "void"}, {7, "mortar"}};
  picture.convert.class_phases = {"mortar", "aggregate"};
  picture.convert.drop_islands = 2e-6;
  picture.itz.mode = specimen::ItzMode::points;
  expect_same(there_and_back(picture, "out"), picture);
}

TEST(SceneText, LeavesOutWhatHasNoEffect) {
  app::Settings settings;
  EXPECT_THAT(app::scene_text(settings, app::Extent::whole, "."), Not(HasSubstr("[convert]")));
  settings.specimen.file = "a.h5";
  const std::string toml = app::scene_text(settings, app::Extent::whole, ".");
  for (const char* table : {"[generate]", "[convert]", "[itz]"}) EXPECT_THAT(toml, Not(HasSubstr(table)));
}

TEST(SceneText, PathsAreRelativeToWhereItIsKept) {
  app::Settings settings;
  settings.specimen.picture = "pictures/a.png";
  EXPECT_THAT(app::scene_text(settings, app::Extent::whole, "runs/a"),
              HasSubstr("picture = \"../../pictures/a.png\""));
  EXPECT_THAT(app::scene_text(settings, app::Extent::whole, "pictures"), HasSubstr("picture = \"a.png\""));
  EXPECT_EQ(std::filesystem::path(there_and_back(settings, "runs/a").specimen.picture).lexically_normal(),
            "pictures/a.png");
}

TEST(SceneText, ForTheSpecimenSaysNothingOfTheLoading) {
  const std::string toml = app::scene_text({}, app::Extent::specimen, ".");
  EXPECT_THAT(toml, HasSubstr("[generate]"));
  EXPECT_THAT(toml, Not(HasSubstr("[loading]")));
  EXPECT_THAT(toml, Not(HasSubstr("[phases")));
}

TEST(SceneText, TellsWhatEachSettingIs) {
  const std::string toml = app::scene_text({}, app::Extent::whole, ".");
  EXPECT_THAT(toml, HasSubstr("velocity = \"0.05 m/s\"            # of the top platen\n"));
  EXPECT_THAT(toml, HasSubstr("# smooth lets the specimen slide sideways, rough holds it (smooth|rough)\n"));
}

TEST(SceneDifferences, AreTheSettingsThatAreNotAllTheSame) {
  const auto found =
      scene_differences({"[loading]\nvelocity = 0.1\ndirection = \"tension\"\n[solver]\ncfl = 0.5\n",
                         "[loading]\nvelocity = 0.2\ndirection = \"tension\"\n[solver]\ncfl = 0.5\n",
                         "[loading]\nvelocity = 0.1\ndirection = \"tension\"\nextra = [1, 2]\n"});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].key, "loading.extra");
  EXPECT_EQ(found[0].values, (std::vector<std::string>{"", "", "[1, 2]"}));
  EXPECT_EQ(found[1].key, "loading.velocity");
  EXPECT_EQ(found[1].values, (std::vector<std::string>{"0.1", "0.2", "0.1"}));
  EXPECT_EQ(found[2].key, "solver.cfl");
  EXPECT_EQ(found[2].values.back(), "");
}

TEST(SceneDifferences, OfTheSameScenesAreNone) {
  EXPECT_TRUE(scene_differences({"[a]\nb = 1\n", "[a]\nb = 1\n"}).empty());
}

TEST(SceneDifferences, RefusesWhatIsNoScene) {
  EXPECT_THROW((void)scene_differences({"[a", "[a]"}), app::Rejected);
  std::string deep = "a = ";
  for (int i = 0; i < 100'000; ++i) deep += '[';
  EXPECT_THROW((void)scene_differences({deep, "[a]"}), app::Rejected)
      << "a parser that calls itself would crash";
}

}  // namespace scene_text_test
