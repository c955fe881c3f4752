/// The program behind main(): finds the subcommand, runs it, and words what went wrong.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/complaint.hpp"
#include "apps/console.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): a library's own
class App;
}

namespace app {

class Command;

/// Each makes a subcommand of the program that it is given.
using MoreCommands = std::vector<std::function<std::unique_ptr<Command>(CLI::App&)>>;

/// @param arguments  without the name of the program.
/// @param more  commands beside those that it always has, in the order of its help.   Never throws.
Exit run_program(const std::vector<std::string>& arguments, Console& console, const MoreCommands& more = {});

}  // namespace app
