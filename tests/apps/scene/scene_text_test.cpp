#include "apps/scene/scene_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <set>
#include <sstream>

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
  settings.scene.local_damping = 0.1 / 3;
  settings.automatic_damping = false;
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

/// A setting, a little larger in SI units; nothing where that is no number or not allowed.
template <class T>
std::optional<T> nudged(const app::FieldOf<T>& field, T object) {
  if (!field.form.measure) return {};
  const app::Dimension dimension = field.form.measure->dimension;
  try {
    app::Value value = field.get(object);
    const auto* text = std::get_if<std::string>(&value.data);
    const double number =
        text == nullptr ? std::get<double>(value.data) : app::parse_quantity(*text, dimension);
    const double larger = std::nextafter(number, 1e300);
    field.set(object,
              text == nullptr ? app::Value{larger} : app::Value{app::format_quantity(larger, dimension)});
    return object;
  } catch (const app::Mistake&) {  // a word, or the largest that is allowed
    return {};
  }
}

TEST(SceneValues, ChangeWithTheLastBitOfAnySetting) {
  const app::Settings settings = unusual_settings();
  const std::string values = app::scene_values(settings, app::Extent::whole);
  EXPECT_EQ(app::scene_values(there_and_back(settings, "out"), app::Extent::whole), values);
  int changed = 0;
  for (const app::Field& field : app::fields())
    if (const auto other = nudged(field, settings); other && app::why_unused(field.key, settings).empty()) {
      EXPECT_NE(app::scene_values(*other, app::Extent::whole), values) << field.key;
      ++changed;
    }
  EXPECT_GE(changed, 15);
  for (const app::PhaseField& property : app::phase_fields())
    if (const auto phase = nudged(property, settings.phases[1])) {
      app::Settings other = settings;
      other.phases[1] = *phase;
      EXPECT_NE(app::scene_values(other, app::Extent::whole), values) << property.key;
    }
}

TEST(SceneValues, ChangeWithListsAndWords) {
  std::set<std::string> texts;
  const auto add = [&](const app::Settings& settings) {
    EXPECT_TRUE(texts.insert(app::scene_values(settings, app::Extent::whole)).second);
  };
  app::Settings settings;
  add(settings);
  settings.scene.loading.platen = mpm::Platen::rough;
  add(settings);
  settings.grading.classes = {{8e-3, 16e-3, 0.7}, {4e-3, 8e-3, 0.3}};
  add(settings);
  settings.grading.classes[1].d_min = std::nextafter(4e-3, 1);
  add(settings);
  settings = {};
  settings.specimen.ellipse_list = {{0.02, 0.03, 0.01, 0.005, 0.3}, {0.05, 1.0 / 30, 0.01, 0.005, 0}};
  add(settings);
  settings.specimen.ellipse_list[1].angle = 1e-300;
  add(settings);
}

TEST(SceneValues, AreNumbersInSiUnitsSortedByKeyAndSayNothingElse) {
  app::Settings settings;
  settings.scene.loading.velocity = 0.05;
  settings.grading.classes = {{8e-3, 16e-3, 0.7}, {4e-3, 8e-3, 0.3}};
  const std::string values = app::scene_values(settings, app::Extent::whole);
  for (const char* line :
       {"\ngenerate.classes = [0.008, 0.016, 0.7, 0.004, 0.008, 0.3]\n", "\ngenerate.pixel_size = 0.0005\n",
        "\nitz.mode = \"ring\"\n", "\nitz.thickness = \"auto\"\n", "\nloading.velocity = 0.05\n",
        "\nitz.segments = \"auto\"\n"})
    EXPECT_THAT(values, HasSubstr(line));
  for (const app::Field& field : app::fields()) EXPECT_THAT(values, Not(HasSubstr(field.help))) << field.key;
  std::istringstream lines(values);
  std::string before;
  for (std::string line; std::getline(lines, line); before = line) {
    EXPECT_LT(before.substr(0, before.find(' ')), line.substr(0, line.find(' ')));
    EXPECT_THAT(line, testing::ContainsRegex("^[a-z0-9_.]+ = (-?[0-9.e-]+|true|false|\".*\"|\\[.*\\])$"));
  }
}

/// Written down once: of a text that another version of the program words otherwise, kept studies know
/// nothing.
TEST(SceneValues, HaveAWordingThatStays) {
  app::Settings settings;
  settings.specimen.picture = "folder/cut.png";
  settings.specimen.sha256 = "abc";
  settings.itz.segments = 12;
  EXPECT_THAT(app::scene_values(settings, app::Extent::specimen),
              testing::AllOf(testing::StartsWith("convert."), HasSubstr("\nellipses = []\n"),
                             HasSubstr("\nitz.segments = 12\nitz.thickness = \"auto\"\n"
                                       "specimen.picture = \"cut.png\"\nspecimen.sha256 = \"abc\"\n")));
}

TEST(SceneText, AsWrittenIsWhatItsReaderGives) {
  const app::Settings settings = unusual_settings();
  const app::Resolved written = app::as_written(settings);
  const app::Resolved read =
      app::resolve(app::parse_scene(app::scene_text(settings, app::Extent::whole, "."), "scene.toml"), {});
  ASSERT_EQ(written.origins.size(), read.origins.size());
  for (const auto& [key, given] : read.origins)
    EXPECT_EQ(app::toml_text(written.origins.at(key).value), app::toml_text(given.value)) << key;
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
