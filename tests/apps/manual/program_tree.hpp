/// The commands of the program, as the tool that writes the manual sees them.
#pragma once

#include <algorithm>

#include "apps/command/program.hpp"
#include "apps/evidence_commands.hpp"
#include "apps/manual/command_tree.hpp"

namespace test {

inline const manual::Command& program_tree() {
  static const manual::Command tree = [] {
    manual::Command made;
    app::look_at_program([&](const CLI::App& root) { made = manual::command_tree(root); },
                         app::evidence_commands());
    return made;
  }();
  return tree;
}

/// The one of these words behind "mesopix": "study submit".
inline const manual::Command& command_named(const std::string& words) {
  for (const manual::Command* command : every_command(program_tree()))
    if (joined(*command, " ") == "mesopix " + words) return *command;
  throw std::invalid_argument("no command " + words);
}

/// The option of that name, dashes included.
inline const manual::Option& option_named(const manual::Command& command, const std::string& name) {
  for (const manual::Option& option : command.options)
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return option;
  throw std::invalid_argument("no option " + name);
}

}  // namespace test
