/// The program behind main(): finds the subcommand, runs it, and words what went wrong.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/system/terminal.hpp"
#include "apps/text/complaint.hpp"

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

using Look = std::function<void(const CLI::App&)>;

/// Lets `look` see the options of the program, those of its commands below them.
void look_at_program(const Look& look, const MoreCommands& more = {});

/// Lets `look` see the options of a command as they are when it is to run, in place of running it.
/// @param arguments  as for run_program; they name a command.
/// @throws Rejected, CLI::ParseError for arguments that do not get so far.
void look_at_parsed(const std::vector<std::string>& arguments, const Look& look,
                    const MoreCommands& more = {});

}  // namespace app
