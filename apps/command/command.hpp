/// What the exit codes of the program mean, in words.
/// What every subcommand is.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/command/command_line.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/complaint.hpp"

namespace app {

struct ExitMeaning {
  Exit code;
  const char* name;   ///< in sysexits.h; empty where it has none
  const char* brief;  ///< "wrong usage"
  const char* whole;  ///< a sentence or two
};

/// Every exit code, the smallest first.
[[nodiscard]] const std::vector<ExitMeaning>& exit_meanings();

/// "0 done, 64 wrong usage, ...", in lines of less than 100 letters.
[[nodiscard]] std::string exit_summary();

class Command {
 public:
  virtual ~Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  [[nodiscard]] Options& options() { return options_; }

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
      : options_(Options::below(parent, name, description)) {
    options_.formatter(help_formatter());
    options_.set_help_flag("-h,--help", "show this help, and do no more");
    options_.footer(example);
    options_.allow_extras();
  }

 private:
  Options& options_;
};

}  // namespace app
