#include "apps/settings/schema.hpp"

#include <gtest/gtest.h>

#include <set>

#include "apps/command/command_line.hpp"
#include "specimen/pack/grading.hpp"

namespace schema_test {

using app::Settings;
using app::Value;

/// Values that differ from the default of a field, whatever its kind; the first one it accepts is used.
std::vector<Value> trial_values() {
  using List = Value::List;
  const auto text = [](const char* words) { return Value{std::string(words)}; };
  return {{true},
          {std::int64_t{3}},
          {std::int64_t{17}},
          {0.25},
          text("0.0625"),
          text("3 mm"),
          text("3 mm2"),
          text("7 GPa"),
          text("30 deg"),
          text("0.3 m/s"),
          text("2 kg/m3"),
          text("3 us"),
          text("40 J/m2"),
          text("fuller"),
          text("A16"),
          text("otsu"),
          text("red"),
          text("points"),
          text("void"),
          text("clipped"),
          text("hordijk"),
          text("rough"),
          text("stress"),
          text("baseline"),
          text("single"),
          text("compression"),
          text("moving"),
          text("linear"),
          text("usl"),
          text("apic"),
          text("quasi_static"),
          text("snap_back"),
          text("pixel"),
          text("open"),
          text("some words"),
          {List{text("5 mm .. 9 mm: 1")}},
          {List{text("3: mortar")}},
          {List{text("mortar")}},
          {List{{80.5}, {90.5}}},
          {List{{std::int64_t{1}}, {std::int64_t{2}}, {std::int64_t{3}}, {std::int64_t{4}}}}};
}

/// Set the field to something else than it is.   @return false when no trial value does it.
bool change(const app::Field& field, Settings& settings) {
  const Value before = field.get(settings);
  for (const Value& trial : trial_values()) {
    try {
      field.set(settings, trial);
    } catch (const app::Mistake&) {
      continue;
    }
    if (field.get(settings) != before) return true;
  }
  return false;
}

std::vector<app::Field> every_field() {
  std::vector<app::Field> all = app::fields();
  for (const char* phase : {"mortar", "fibre"})
    for (const app::PhaseField& property : app::phase_fields())
      all.push_back(*app::find_field("phases." + std::string(phase) + "." + property.key));
  return all;
}

TEST(Schema, EveryFieldWritesWhatItReads) {
  for (const app::Field& field : every_field()) {
    Settings settings;
    if (app::group_of(field.key) != "phases" || field.key.find("fibre") == std::string::npos) {
      // The default is readable, too; only a phase without material has none.
      ASSERT_NO_THROW(field.set(settings, field.get(settings))) << field.key;
    }
    ASSERT_TRUE(change(field, settings)) << field.key;
    const Value written = field.get(settings);
    Settings other;
    field.set(other, written);
    EXPECT_EQ(field.get(other), written) << field.key;
  }
}

TEST(Schema, EachFieldChangesItselfAlone) {
  const std::vector<app::Field> all = every_field();
  for (const app::Field& field : all) {
    Settings settings;
    ASSERT_TRUE(change(field, settings)) << field.key;
    const Settings untouched;
    for (const app::Field& other : all)
      EXPECT_EQ(other.get(settings) == other.get(untouched), other.key != field.key)
          << field.key << " " << other.key;
  }
}

TEST(Schema, KeysAreUniqueAndBelongToAGroup) {
  std::set<std::string> keys;
  std::set<std::string> names;
  for (const app::Group& group : app::groups()) names.insert(group.name);
  for (const app::Field& field : app::fields()) {
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
    EXPECT_TRUE(names.count(app::group_of(field.key))) << field.key;
    EXPECT_FALSE(field.help.empty()) << field.key;
  }
}

TEST(Schema, ShortOptionsOfASubcommandAreUnique) {
  const std::vector<std::vector<std::string>> subcommands{
      {"specimen", "generate", "itz"},
      {"convert", "itz"},
      {"loading", "damage", "solver", "motion", "handover", "output"}};
  for (const auto& own : subcommands) {
    std::set<std::string> options{"help",  "set",       "output",    "json",
                                  "quiet", "overwrite", "reference", "print-scene"};
    for (const app::Group& group : app::groups())
      for (const app::Field& field : app::fields())
        if (app::group_of(field.key) == group.name && std::count(own.begin(), own.end(), group.name) > 0) {
          EXPECT_TRUE(options.insert(app::short_option(group, field)).second) << field.key;
        }
  }
}

TEST(Schema, DefaultsAreThoseOfTheLibraries) {
  const Settings settings;
  const specimen::Grading chosen = app::packing_options(settings).grading;
  const specimen::Grading own = specimen::PackingOptions().grading;
  ASSERT_EQ(chosen.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(chosen[i].d_min, own[i].d_min);
    EXPECT_EQ(chosen[i].d_max, own[i].d_max);
    EXPECT_EQ(chosen[i].share, own[i].share);
  }
  EXPECT_EQ(app::find_field("phases.mortar.tensile_scale")->get(settings), Value{std::string("15 MPa")});
  EXPECT_EQ(app::find_field("phases.aggregate.cohesion")->get(settings), Value{std::string("unbreakable")});
  EXPECT_EQ(app::find_field("loading.velocity")->get(settings), Value{std::string("0.05 m/s")});
}

TEST(FindField, KnowsPhasesOfAnyUsableName) {
  EXPECT_TRUE(app::find_field("phases.steel-fibre_2.young"));
  EXPECT_FALSE(app::find_field("phases.a b.young"));
  EXPECT_FALSE(app::find_field("phases.mortar.colour"));
  EXPECT_FALSE(app::find_field("phases.young"));
  EXPECT_FALSE(app::find_field("phases..young"));
  EXPECT_FALSE(app::find_field(""));
}

std::string suggestion_for(std::string_view key) { return text(app::suggest_key(key, Settings())); }

TEST(SuggestKey, FindsWhatWasMeant) {
  EXPECT_EQ(suggestion_for("loading.velocty"), "did you mean loading.velocity?");
  EXPECT_EQ(suggestion_for("velocity"), "did you mean loading.velocity?");
  EXPECT_EQ(suggestion_for("solver.velocity"), "did you mean loading.velocity?");
  EXPECT_EQ(suggestion_for("phases.mortar.yung"), "did you mean phases.mortar.young?");
  EXPECT_EQ(suggestion_for("loadng"), "did you mean loading?");
  EXPECT_EQ(suggestion_for("damage.quux"),
            "damage has seed, crack_closure, residual_stiffness and correlation_length");
  EXPECT_EQ(suggestion_for("quux"),
            "the tables of a scene are specimen, generate, convert, itz, phases, loading, damage, solver, "
            "motion, handover, output, cuts, supports, loads and gauges");
}

TEST(WhyUnused, DependsOnSettingsThatAreKnownToDecide) {
  for (const mpm::Kinematics kinematics : {mpm::Kinematics::small_strain, mpm::Kinematics::moving})
    for (const app::Field& decider : app::fields())
      for (const Value& trial : trial_values()) {
        Settings settings;
        settings.scene.kinematics = kinematics;
        Settings changed = settings;
        try {
          decider.set(changed, trial);
        } catch (const app::Mistake&) {
          continue;
        }
        for (const app::Field& other : app::fields())
          if (app::why_unused(other.key, settings) != app::why_unused(other.key, changed)) {
            EXPECT_TRUE(app::decides_use(decider.key)) << decider.key << " " << other.key;
          }
      }
}

TEST(WhyUnused, DependsOnTheSource) {
  Settings settings;
  EXPECT_EQ(app::why_unused("generate.fraction", settings), "");
  EXPECT_EQ(app::why_unused("convert.width", settings), "has an effect on pictures only");
  EXPECT_EQ(app::why_unused("specimen.sha256", settings), "is that of a file, and none is given");
  settings.grading.classes = {{5e-3, 9e-3, 1}};
  EXPECT_EQ(app::why_unused("generate.d_min", settings), "has no effect beside generate.classes");
  settings.specimen.ellipse_list.push_back({});
  EXPECT_EQ(app::why_unused("generate.width", settings), "");
  EXPECT_EQ(app::why_unused("generate.seed", settings), "has no effect on given ellipses");
  settings.specimen.picture = "a.png";
  EXPECT_EQ(app::why_unused("convert.width", settings), "");
  EXPECT_EQ(app::why_unused("generate.width", settings), "has no effect on a picture");
  settings.specimen.file = "a.h5";
  EXPECT_EQ(app::why_unused("itz.mode", settings), "has no effect on a specimen that is there already");
  EXPECT_EQ(app::why_unused("loading.velocity", settings), "");
}

TEST(WhyUnused, DependsOnTheKinematics) {
  Settings settings;
  const char* moving_only = "has an effect with solver.kinematics = \"moving\" or \"auto\" only";
  const char* auto_only = "has an effect with solver.kinematics = \"auto\" only";
  settings.scene.loading.direction = mpm::Direction::compression;
  for (const char* key : {"motion.shape", "motion.margin", "motion.left", "loading.separation"}) {
    settings.scene.kinematics = mpm::Kinematics::small_strain;
    EXPECT_EQ(app::why_unused(key, settings), moving_only) << key;
    settings.scene.kinematics = mpm::Kinematics::moving;
    EXPECT_EQ(app::why_unused(key, settings), "") << key;
    settings.scene.kinematics = mpm::Kinematics::automatic;
    EXPECT_EQ(app::why_unused(key, settings), "") << key;
  }
  EXPECT_EQ(app::why_unused("handover.strain", settings), "");
  settings.scene.kinematics = mpm::Kinematics::moving;
  EXPECT_EQ(app::why_unused("handover.strain", settings), auto_only);
  settings.scene.motion.transfer = mpm::Transfer::apic;
  EXPECT_EQ(app::why_unused("motion.flip_ratio", settings), "has no effect with motion.transfer = \"apic\"");
}

TEST(WhyUnused, DependsOnThePlatens) {
  Settings settings;
  settings.scene.kinematics = mpm::Kinematics::moving;
  const std::vector<std::string> of_platens{"loading.velocity", "loading.platen", "loading.separation",
                                            "loading.ramp_time", "loading.stop_strain"};
  const std::vector<std::string> of_flight{"loading.initial_velocity_x", "loading.initial_velocity_y",
                                           "loading.duration", "motion.bottom", "motion.top"};
  for (const std::string& key : of_platens) EXPECT_EQ(app::why_unused(key, settings), "") << key;
  for (const std::string& key : of_flight)
    EXPECT_EQ(app::why_unused(key, settings), "has an effect with loading.direction = \"none\" only") << key;
  settings.scene.loading.direction = mpm::Direction::none;
  for (const std::string& key : of_flight) EXPECT_EQ(app::why_unused(key, settings), "") << key;
  for (const std::string& key : of_platens)
    EXPECT_EQ(app::why_unused(key, settings), "has no effect with loading.direction = \"none\"") << key;
}

TEST(WhyUnused, LooksForAnEdgeThatTheGridReachesBeyond) {
  Settings settings;
  settings.scene.kinematics = mpm::Kinematics::moving;
  settings.scene.motion.left = settings.scene.motion.right = mpm::Edge::smooth_wall;
  EXPECT_EQ(app::why_unused("motion.margin", settings), "has no effect where no edge is closed or open");
  settings.scene.loading.direction = mpm::Direction::none;
  EXPECT_EQ(app::why_unused("motion.margin", settings), "");
  settings.scene.motion.bottom = settings.scene.motion.top = mpm::Edge::symmetry;
  EXPECT_EQ(app::why_unused("motion.margin", settings), "has no effect where no edge is closed or open");
  settings.scene.motion.right = mpm::Edge::open;
  EXPECT_EQ(app::why_unused("motion.margin", settings), "");
}

TEST(Schema, ReadsTheFormerNameOfTheCell) {
  Settings settings;
  app::find_field("solver.points_per_cell")->set(settings, {std::int64_t{3}});
  EXPECT_EQ(app::find_field("solver.cell")->get(settings), Value{std::string("3 x 3")});
  app::find_field("solver.cell")->set(settings, {std::string("pixel")});
  EXPECT_TRUE(settings.scene.pixel_cells);
  EXPECT_EQ(settings.scene.points_per_cell, 1);
  for (const app::Field& field : app::fields()) EXPECT_NE(field.key, "solver.points_per_cell");
}

TEST(Schema, KnowsWhatEquilibriumHasNoUseFor) {
  Settings settings;
  for (const char* key : {"solver.event_tolerance", "loading.path"})
    EXPECT_EQ(app::why_unused(key, settings), "has an effect with solver.method = \"quasi_static\" only");
  settings.scene.method = mpm::SolverMethod::quasi_static;
  for (const char* key : {"solver.event_tolerance", "loading.path"})
    EXPECT_EQ(app::why_unused(key, settings), "") << key;
  app::find_field("loading.path")->set(settings, {std::string("snap_back")});
  EXPECT_EQ(settings.scene.loading.path, mpm::LoadingPath::snap_back);
  for (const char* key : {"loading.velocity", "loading.ramp_time", "solver.cfl", "solver.local_damping"})
    EXPECT_EQ(app::why_unused(key, settings), "has no effect with solver.method = \"quasi_static\"") << key;
  EXPECT_EQ(app::why_unused("solver.threads", settings), "");
}

}  // namespace schema_test
