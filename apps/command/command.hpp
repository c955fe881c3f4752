/// What every subcommand is.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/command/command_line.hpp"
#include "apps/text/complaint.hpp"
#include "apps/system/console.hpp"

namespace app {

class Command {
 public:
  virtual ~Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  [[nodiscard]] CLI::App& options() { return options_; }

  /// Arguments behind the name of the subcommand, as they may be handed to the parser.
  [[nodiscard]] virtual std::vector<std::string> prepare(const std::vector<std::string>& arguments) {
    return arguments;
  }

  /// Do what the parsed options say.   @throws Rejected and the exceptions of the libraries.
  virtual Exit run(Console& console) = 0;

 protected:
  /// @param parent  the program, or the options of a command that has this one below it.
  Command(CLI::App& parent, const std::string& name, const std::string& description,
          const std::string& example)
      : options_(*parent.add_subcommand(name, description)) {
    options_.formatter(help_formatter());
    options_.set_help_flag("-h,--help", "show this help, and do no more");
    options_.footer(example);
    options_.allow_extras();
  }

 private:
  CLI::App& options_;
};

/// What an INPUT is, told by its first bytes and, for scenes, by its name.
enum class InputKind { hdf5, scene, picture, folder };

/// @throws Rejected (Exit::io) when there is nothing that can be read.
[[nodiscard]] InputKind kind_of_input(const std::string& path);

}  // namespace app
