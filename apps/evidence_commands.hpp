/// The commands that compare the program with the paper and with known answers, reproduce and bench; none in
/// a build without them.
#pragma once

#include "apps/command/program.hpp"

namespace app {

[[nodiscard]] MoreCommands evidence_commands();

}  // namespace app
