/// What shells complete behind "mesopix".
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

}  // namespace manual
