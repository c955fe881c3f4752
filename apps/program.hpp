/// The program behind main(): finds the subcommand, runs it, and words what went wrong.
#pragma once

#include <string>
#include <vector>

#include "apps/complaint.hpp"
#include "apps/console.hpp"

namespace app {

/// @param arguments  without the name of the program.   Never throws.
Exit run_program(const std::vector<std::string>& arguments, Console& console);

}  // namespace app
