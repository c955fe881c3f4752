// The scenes that mesopix scene init writes.
#include "apps/scene/scene_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "apps/scene/test_scenes.hpp"
#include "apps/settings/scene_lists.hpp"
#include "apps/settings/schema.hpp"
#include "apps/system/hdf5_files.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/version.hpp"
#include "specimen/picture/picture.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

/// What the scene gives: keys with what the command line would say.
using LiveSettings = std::vector<std::pair<std::string, std::string>>;

/// A square of which every grain has some points, and which is solved in seconds.
LiveSettings random_aggregates() {
  return {{"generate.width", "50 mm"},   {"generate.height", "50 mm"}, {"generate.pixel_size", "0.5 mm"},
          {"generate.fraction", "40 %"}, {"generate.d_min", "4 mm"},   {"generate.d_max", "12 mm"},
          {"generate.seed", "1"}};
}

constexpr int columns_of_first_run = 200;  // of a picture: enough to see grains, few enough for seconds

LiveSettings of_picture(const DraftWish& wish) {
  const specimen::Picture picture = specimen::read_picture(wish.picture);
  if (wish.width.empty() && !(picture.pixel_size > 0))
    throw Rejected(Exit::data, wish.picture, "does not tell its scale", "",
                   "measure how wide what it shows is, and give --width \"40 mm\"");
  LiveSettings live{{"specimen.picture", wish.picture}};
  if (!wish.width.empty()) live.emplace_back("convert.width", wish.width);
  if (picture.cols() > columns_of_first_run)
    live.emplace_back("convert.pixels", std::to_string(columns_of_first_run));
  return live;
}

LiveSettings of_source(const DraftWish& wish) {
  if (!wish.picture.empty()) return of_picture(wish);
  if (!wish.specimen.empty()) return {{"specimen.file", wish.specimen}};
  return random_aggregates();
}

struct DraftLoading {
  const char* words;  ///< what is done to the specimen
  LiveSettings settings;
};

DraftLoading loading_of(mpm::Direction direction) {
  switch (direction) {
    case mpm::Direction::tension:
      return {"in tension",
              {{"loading.direction", "tension"},
               {"loading.velocity", "0.1 m/s"},
               {"loading.stop_strain", "6e-4"},
               {"loading.stop_drop", "0.2"}}};
    case mpm::Direction::compression:
      return {"in compression",
              {{"loading.direction", "compression"},
               {"loading.velocity", "0.5 m/s"},
               {"loading.stop_strain", "4e-3"},
               {"loading.stop_drop", "0.5"}}};
    case mpm::Direction::none:
      break;
  }
  return {"thrown against a wall",
          {{"loading.direction", "none"},
           {"loading.initial_velocity_y", "-10 m/s"},
           {"loading.duration", "0.5 ms"},
           {"solver.kinematics", "moving"},
           {"motion.bottom", "smooth_wall"},
           {"motion.left", "open"},
           {"motion.right", "open"},
           {"motion.top", "open"}}};
}

std::string subject(const DraftWish& wish, const char* without_file) {
  const std::string& file = wish.picture.empty() ? wish.specimen : wish.picture;
  return file.empty() ? without_file : printable(fs::path(file).filename().string());
}

/// All that the scene gives, and what would hold without it.
class Draft {
 public:
  explicit Draft(const DraftWish& wish) : folder_(fs::path(wish.file).parent_path()) {
    if (!wish.test.empty()) {
      const TestScene& test = test_scene_named(wish.test);
      give(test.settings);
      give({{"output.title", test.title}});
      return;
    }
    give(of_source(wish));
    const DraftLoading loading = loading_of(wish.direction);
    give(loading.settings);
    give({{"damage.seed", "1"}, {"solver.cfl", "0.8"}});
    give({{"output.title", subject(wish, "Random aggregates") + " " + loading.words}});
    if (!wish.specimen.empty()) add_phases(read_specimen(wish.specimen).mask.phases);
  }

  [[nodiscard]] std::string tables() const {
    std::string text;
    for (const Group& group : groups())
      text +=
          group.name == "phases" ? phase_tables() : table(group.title, group.name, group_lines(group.name));
    for (const SceneList& list : scene_lists()) text += item_tables(list);
    return text;
  }

 private:
  void give(const LiveSettings& settings) {
    for (const auto& [key, text] : settings) {
      const Field field = *find_field(key);
      try {
        field.set(settings_, from_command_line(field.form.kind, text));
      } catch (const Mistake& mistake) {
        throw Rejected(Exit::usage, "--" + leaf_of(key), quoted(text), mistake.allowed, mistake.cure);
      }
      given_.insert(key);
    }
  }

  /// Phases that are none of concrete begin as mortar: what they are made of nobody has said.
  void add_phases(const std::vector<std::string>& names) {
    const mpm::Phase mortar = phase_named(settings_, "mortar");
    for (const std::string& name : names) {
      const bool known =
          name == "void" || std::any_of(settings_.phases.begin(), settings_.phases.end(),
                                        [&](const mpm::Phase& phase) { return phase.name == name; });
      if (known || !is_phase_name(name)) continue;
      settings_.phases.push_back(mortar);
      settings_.phases.back().name = name;
      new_phases_.insert(name);
    }
  }

  template <class T>
  static std::string line(const FieldOf<T>& field, const Value& value, const std::string& default_value,
                          bool given) {
    const std::string setting =
        fmt::format("{}{} = {}", given ? "" : "#", leaf_of(field.key), toml_text(value));
    const std::string comment =
        fmt::format("# {}; {}{}", field.help, text(field.form),
                    given && !default_value.empty() ? " [" + default_value + "]" : "");
    const std::string one = fmt::format("{:<34} {}\n", setting, comment);
    constexpr std::size_t longest = 120;
    return one.size() <= longest ? one : comment + "\n" + setting + "\n";
  }

  static std::string table(const std::string& title, const std::string& name, const std::string& lines) {
    return lines.empty() ? "" : fmt::format("\n# {}\n[{}]\n{}", title, name, lines);
  }

  [[nodiscard]] std::string group_lines(const std::string& group) const {
    static const Settings defaults;
    std::string lines;
    for (const Field& field : fields_of(group)) {
      const bool given = given_.count(field.key) > 0;
      if (!why_unused(field.key, settings_).empty()) continue;
      const Value usual = field.get(defaults);
      Value value = given ? field.get(settings_) : usual;
      if (is_empty_text(value)) continue;  // there is nothing that could be shown
      if (given && field.form.kind == Kind::path) value = relative_to(folder_, value);
      lines += line(field, value, is_empty_text(usual) ? "" : toml_text(usual), given);
    }
    return lines;
  }

  /// The tables of a list, each with what it gives and what it could.
  [[nodiscard]] std::string item_tables(const SceneList& list) const {
    std::string text;
    for (std::size_t i = 0; i < list.size(settings_); ++i) {
      text += i == 0 ? "\n# " + list.help + "\n" : "\n";
      text += "[[" + list.name + "]]\n";
      for (const Field& field : list.fields(i))
        if (const Value value = field.get(settings_); !is_empty_text(value) && !is_empty_list(value))
          text += line(field, value, "", given_.count(field.key) > 0);
    }
    return text;
  }

  [[nodiscard]] std::string phase_tables() const {
    std::string text;
    for (const mpm::Phase& phase : settings_.phases) {
      const bool is_new = new_phases_.count(phase.name) > 0;
      std::string lines;
      for (const PhaseField& property : phase_fields())
        lines += line(property, property.get(phase), "",
                      is_new || property.key == "young" || property.key == "tensile_scale" ||
                          given_.count("phases." + phase.name + "." + property.key) > 0);
      text += table("Phase " + phase.name + (is_new ? ": as mortar; give what it is made of" : ""),
                    "phases." + phase.name, lines);
    }
    return text;
  }

  fs::path folder_;
  Settings settings_;
  std::set<std::string> given_;
  std::set<std::string> new_phases_;
};

/// The line by which editors find the schema.
std::string schema_line(const DraftWish& wish) {
  if (wish.schema.empty()) return {};
  const Value relative = relative_to(fs::path(wish.file).parent_path(), {wish.schema});
  return "#:schema ./" + std::get<std::string>(relative.data) + "\n";
}

}  // namespace

std::string scene_draft(const DraftWish& wish) {
  const Draft draft(wish);
  const std::string name = printable(fs::path(wish.file).filename().string());
  const std::string about = wish.test.empty()
                                ? subject(wish, "random aggregates") + " " + loading_of(wish.direction).words
                                : test_scene_named(wish.test).title;
  return schema_line(wish) +
         fmt::format(
             "# A scene of mesopix {}: {}.\n"
             "#   mesopix scene check {}\n"
             "#   mesopix simulate {}\n"
             "# Lines like #key = value show what holds without them; take the # away to change it. "
             "Behind a setting stand what it is,\n"
             "# what is allowed and, in brackets, what would hold without it. Quantities are texts "
             "with a unit, ratios numbers or\n"
             "# texts with %. Tables that have no effect on this scene are left out: mesopix simulate "
             "--help tells of all.\n",
             version(), about, name, name) +
         draft.tables();
}

}  // namespace app
