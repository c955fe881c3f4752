#include "apps/manual/command_tree.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace manual {
namespace {

Option option_of(const CLI::Option& option) {
  Option made;
  for (const std::string& letter : option.get_snames()) made.names.push_back("-" + letter);
  for (const std::string& name : option.get_lnames()) made.names.push_back("--" + name);
  if (option.get_items_expected_max() != 0) made.type = option.get_type_name();
  made.help = option.get_description();
  made.group = option.get_group();
  // A setting takes all of its values too, to refuse a second one with its name; those have a key, with a
  // dot.
  const bool setting = made.names.back().find('.') != std::string::npos;
  made.repeatable = !setting && (option.get_items_expected_max() > 1 ||
                                 option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll);
  return made;
}

/// An argument that may be left out has brackets in its name.
Argument argument_of(const CLI::Option& option) {
  Argument made;
  made.name = option.get_name(true, false);
  made.optional = made.name.front() == '[';
  if (made.optional) made.name = made.name.substr(1, made.name.size() - 2);
  made.help = option.get_description();
  made.repeatable = option.get_items_expected_max() > 1;
  return made;
}

Command tree(const CLI::App& app, std::vector<std::string> words) {
  Command made;
  words.push_back(app.get_name());
  made.words = std::move(words);
  made.description = app.get_description();
  made.group = app.get_group();
  made.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional())
      made.arguments.push_back(argument_of(*option));
    else
      made.options.push_back(option_of(*option));
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; }))
    made.below.push_back(tree(*below, made.words));
  return made;
}

}  // namespace

Command command_tree(const CLI::App& program) { return tree(program, {}); }

std::vector<const Command*> every_command(const Command& command) {
  std::vector<const Command*> all{&command};
  for (const Command& below : command.below)
    for (const Command* one : every_command(below)) all.push_back(one);
  return all;
}

std::string joined(const Command& command, const std::string& between) {
  std::string text;
  for (const std::string& word : command.words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> option_groups(const Command& command) {
  std::vector<std::string> groups;
  for (const Option& option : command.options)
    if (!option.group.empty() && std::find(groups.begin(), groups.end(), option.group) == groups.end())
      groups.push_back(option.group);
  return groups;
}

std::string synopsis(const Command& command) {
  std::string text = joined(command, " ") + " [OPTION...]";
  for (const Argument& argument : command.arguments) {
    const std::string name = argument.name + (argument.repeatable ? "..." : "");
    text += argument.optional ? " [" + name + "]" : " " + name;
  }
  return text;
}

}  // namespace manual
