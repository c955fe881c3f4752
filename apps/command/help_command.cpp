#include "apps/command/command.hpp"

#include <algorithm>

#include "apps/system/terminal.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

constexpr const char* help_footer =
    "The same as --help behind a command. man mesopix has it too, where the program is installed.\n"
    "Examples:\n"
    "  mesopix help simulate\n"
    "  mesopix help study submit";

/// @param name  of the parent, for the message.   @throws Rejected (Exit::usage) for a word that is none.
const CLI::App& command_below(const CLI::App& parent, const std::string& name, const std::string& word) {
  const std::vector<const CLI::App*> below = parent.get_subcommands([](const CLI::App*) { return true; });
  const auto found =
      std::find_if(below.begin(), below.end(), [&](const auto* one) { return one->get_name() == word; });
  if (found != below.end()) return **found;
  std::vector<std::string> names;
  for (const CLI::App* one : below) names.push_back(one->get_name());
  throw Rejected(Exit::usage, word, "unknown command",
                 names.empty() ? name + " has no commands below it" : "must be " + listed(names),
                 did_you_mean(word, names));
}

/// Commands below one, and those below them.
std::vector<std::string> names_below(const CLI::App& parent) {
  std::vector<std::string> names;
  for (const CLI::App* below : parent.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(below->get_name());
    const std::vector<std::string> deeper = names_below(*below);
    names.insert(names.end(), deeper.begin(), deeper.end());
  }
  return names;
}

class HelpCommand : public Command {
 public:
  explicit HelpCommand(CLI::App& program)
      : Command(program, "help", "Tell how a command is used, as --help behind it does", help_footer) {
    Form command = text_form("COMMAND");
    command.hints = names_below(program);
    option("[COMMAND]", words_, "name of a command, and of one below it", std::move(command));
  }

  Exit run(Console& console) override {
    const CLI::App* command = options().get_parent();
    std::string name = command->get_name();
    for (const std::string& word : words_) {
      command = &command_below(*command, name, word);
      name += " " + word;
    }
    // Its own help() would be that of the command that was parsed, which is this one.
    console.out << with_headings(
        command->get_formatter()->make_help(command, name, CLI::AppFormatMode::Normal),
        console.out_is_coloured);
    return Exit::ok;
  }

 private:
  std::vector<std::string> words_;
};

}  // namespace

CommandPointer help_command(CLI::App& parent) { return std::make_unique<HelpCommand>(parent); }

}  // namespace app
