/// The commands of the program with their options, as plain data for manual pages, completions and the
/// reference.
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): a library's own
class App;
}

namespace manual {

struct Option {
  std::vector<std::string> names;  ///< "-o", "--output"; "--velocity", "--loading.velocity"
  std::string type;                ///< "DIR", "smooth|rough"; empty = takes no value
  std::string help;
  std::string group;        ///< heading of the help; empty = understood and not listed there
  bool repeatable = false;  ///< each one adds to those before it
};

struct Argument {
  std::string name;  ///< "SCENE"
  std::string help;
  bool optional = false;
  bool repeatable = false;
};

struct Command {
  std::vector<std::string> words;  ///< "mesopix", "study", "submit"
  std::string description;         ///< one line
  std::string group;               ///< heading among its neighbours
  std::string footer;              ///< what the help says at its end
  std::vector<Argument> arguments;
  std::vector<Option> options;
  std::vector<Command> below;
};

/// The program with all commands below it.
[[nodiscard]] Command command_tree(const CLI::App& program);

/// The command and all below it, each before those below it.
[[nodiscard]] std::vector<const Command*> every_command(const Command& command);

/// Its words with something between them: "mesopix study submit", "mesopix-study-submit".
[[nodiscard]] std::string joined(const Command& command, const std::string& between);

/// Headings of its listed options in the order of the help.
[[nodiscard]] std::vector<std::string> option_groups(const Command& command);

/// "mesopix report [OPTION...] RUN...".
[[nodiscard]] std::string synopsis(const Command& command);

}  // namespace manual
