/// What shells complete behind "mesopix".
/// Lists of words as the shells take them.
#pragma once

#include <string>
#include <vector>

#include "apps/manual/command_tree.hpp"
#include "apps/manual/man_pages.hpp"

namespace manual {

/// mesopix.bash, _mesopix and mesopix.fish.
[[nodiscard]] std::vector<File> completions(const Command& program);

[[nodiscard]] std::string bash_completion(const Command& program);
[[nodiscard]] std::string zsh_completion(const Command& program);
[[nodiscard]] std::string fish_completion(const Command& program);

/// "a b c".
[[nodiscard]] inline std::string spaced(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// Last words of the commands below one.
[[nodiscard]] inline std::vector<std::string> names_below(const Command& command) {
  std::vector<std::string> names;
  for (const Command& below : command.below) names.push_back(below.words.back());
  return names;
}

/// Of all commands.
[[nodiscard]] inline std::vector<std::string> names_of_commands(const Command& program) {
  std::vector<std::string> names;
  for (const Command* command : every_command(program))
    if (command != &program) names.push_back(command->words.back());
  return names;
}

}  // namespace manual
