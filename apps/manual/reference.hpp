/// The reference of commands, scenes and exit codes in Markdown.
#pragma once

#include <string>
#include <vector>

#include "apps/manual/command_tree.hpp"
#include "apps/manual/man_pages.hpp"

namespace manual {

/// commands.md, scene.md and exit_codes.md.
/// @param scene  text of a scene, for the example.
[[nodiscard]] std::vector<File> reference(const Command& program, const std::string& scene);

[[nodiscard]] std::string commands_page(const Command& program);
[[nodiscard]] std::string scene_page(const std::string& scene);
[[nodiscard]] std::string exit_codes_page();

}  // namespace manual
