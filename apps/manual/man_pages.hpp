/// The manual pages of the program.
#pragma once

#include <string>
#include <vector>

#include "apps/manual/command_tree.hpp"

namespace manual {

struct File {
  std::string name;  ///< "mesopix-simulate.1"
  std::string text;
};

/// A page for the program and each of its commands, and mesopix-scene.5.
/// @param scene  text of a scene, for the example.
[[nodiscard]] std::vector<File> man_pages(const Command& program, const std::string& scene);

/// The one of the command.
[[nodiscard]] std::string command_man_page(const Command& command, const Command& program);

/// The one of scene files.
[[nodiscard]] std::string scene_man_page(const std::string& scene);

}  // namespace manual
