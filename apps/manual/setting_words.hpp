/// What the schema says of a setting, in words.
#pragma once

#include <string>
#include <vector>

#include "apps/settings/schema.hpp"

namespace manual {

struct SettingWords {
  std::string key;            ///< in its table: "velocity"
  std::string type;           ///< "VELOCITY", "smooth|rough"; "true|false" of a switch
  std::string default_value;  ///< as TOML writes it; empty = none
  std::string allowed;        ///< "> 0", "in [0, 1)", "" where the type says it all
  std::string help;
};

/// A table of scene files.
struct TableWords {
  std::string name;   ///< "loading"; "phases.NAME"
  std::string title;  ///< "Loading"
  std::vector<SettingWords> settings;
};

/// All tables with all keys, in the order in which they are written.
[[nodiscard]] std::vector<TableWords> scene_tables();

/// Lists of tables, as [[loads]]; the name is in single brackets, the title a sentence.
[[nodiscard]] std::vector<TableWords> list_tables();

/// Paragraphs on what a scene file is, and on ellipses that stand in it.
[[nodiscard]] std::vector<std::string> about_scenes();
[[nodiscard]] std::string about_ellipses();

/// What numbers a type stands for, and the units they are written in.
struct TypeWords {
  std::string name;     ///< "LENGTH"
  std::string units;    ///< "mm, m, um, cm or µm"
  std::string example;  ///< "0.5 mm"
};
[[nodiscard]] std::vector<TypeWords> quantity_types();

}  // namespace manual
