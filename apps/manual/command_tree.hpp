/// The commands of the program with their options, and what their help says, as plain data.
#pragma once

#include <string>
#include <vector>

#include "apps/settings/form.hpp"

namespace manual {

/// A line of two columns.
struct Item {
  std::string term;
  std::string text;
};

/// One of the three: text that flows, lines that stay as they are, or a list.
struct Passage {
  std::string text;
  std::vector<std::string> verbatim;  ///< without the two blanks before each
  std::vector<Item> items;
};

struct HelpText {
  std::vector<Passage> notes;
  std::vector<Passage> examples;  ///< from the line that begins with "Example" on
};

[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

/// Lines that begin with two blanks stay as they are; lines with more blanks inside are items of a list, and
/// what is indented farther goes on with one; all others flow.
[[nodiscard]] HelpText help_text(const std::string& footer);

}  // namespace manual

namespace CLI {  // NOLINT(readability-identifier-naming): a library's own
class App;
}

namespace manual {

struct Option {
  std::vector<std::string> names;  ///< as the help shows them: "-o", "--output"
  std::string by_key;              ///< of a setting: "--loading.velocity"
  app::Form form;                  ///< what stands behind it
  std::string help;
  std::string group;  ///< heading of the help
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
  std::vector<Option> options;    ///< that the help shows
  std::vector<std::string> keys;  ///< of settings, which --set takes
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

/// One of its keys as an option, for a sentence on them: "--generate.width".   @pre there is a key.
[[nodiscard]] std::string option_by_key(const Command& command);

/// "mesopix report [OPTION...] RUN...".
[[nodiscard]] std::string synopsis(const Command& command);

}  // namespace manual
