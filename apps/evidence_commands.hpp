/// The commands that show what the program is worth: reproduce and bench; none in a build without them.
#pragma once

#include "apps/command/program.hpp"

namespace app {

[[nodiscard]] MoreCommands evidence_commands();

}  // namespace app
