#include "apps/manual/completions.hpp"
#include "apps/manual/expected_value.hpp"

namespace manual {
namespace {

/// Within single quotes.
std::string zsh_quoted(const std::string& text) {
  std::string made = "'";
  for (const char letter : text) made += letter == '\'' ? "'\\''" : std::string(1, letter);
  return made + "'";
}

/// Without meaning to _arguments and _describe.
std::string zsh_escaped(const std::string& text) {
  std::string made;
  for (const char letter : text)
    made += (std::string("[]:\\").find(letter) == std::string::npos ? "" : "\\") + std::string(1, letter);
  return made;
}

std::string function_of(const Command& command) { return "_" + joined(command, "_"); }

std::string files_action(const ExpectedValue& value) {
  if (value.endings.empty()) return "_files";
  std::string endings;
  for (const std::string& ending : value.endings) endings += (endings.empty() ? "" : "|") + ending;
  return "_files -g \"*.(#i)(" + endings + ")(-.)\"";
}

/// The third part of a specification for _arguments; a blank = there is nothing to complete.
std::string zsh_action(const ExpectedValue& value, const Command& command) {
  if (value.keys) return function_of(command) + "_keys";
  if (value.commands) return "_mesopix_all_commands";
  if (value.files) return files_action(value);
  if (value.folders) return "_files -/";
  return value.words.empty() ? " " : "(" + spaced(value.words) + ")";
}

std::string specification(const Option& option, const std::string& name, const Command& command) {
  const bool listed =
      !listed_names(option).empty() && (name.find('.') == std::string::npos || name == option.names[0]);
  const std::string others = option.repeatable ? "" : "(" + spaced(option.names) + ")";
  std::string text = (listed ? "" : "!") + others + (option.repeatable ? "*" : "") + name;
  if (option.type.empty()) return zsh_quoted(text + "[" + zsh_escaped(option.help) + "]");
  const bool is_long = name[1] == '-';
  return zsh_quoted(text + (is_long ? "=" : "") + "[" + zsh_escaped(option.help) +
                    "]:" + zsh_escaped(option.type) + ":" + zsh_action(expected(option), command));
}

std::string argument_specification(const Argument& argument, const Command& command, bool first) {
  std::string does = zsh_action(expected(argument), command);
  if (first && !command.below.empty()) does = "{ " + function_of(command) + "_commands; " + does + " }";
  const std::string place = argument.repeatable ? "*" : "";
  return zsh_quoted(place + ":" + argument.name + ":" + does);
}

std::string zsh_commands_function(const std::string& name, const std::vector<const Command*>& commands) {
  std::string text = name + "() {\n  local -a commands=(\n";
  for (const Command* command : commands)
    text += "    " + zsh_quoted(command->words.back() + ":" + zsh_escaped(command->description)) + "\n";
  return text + "  )\n  _describe -t commands command commands\n}\n\n";
}

/// Hands on to the command below that is typed.
std::string hand_on(const Command& command) {
  std::string text = "  if (( CURRENT > 2 )); then\n    case $words[2] in\n";
  for (const Command& below : command.below)
    text += "      " + below.words.back() + ") shift words; (( CURRENT-- )); " + function_of(below) +
            "; return ;;\n";
  return text + "    esac\n  fi\n";
}

std::string keys_function(const Command& command) {
  const std::vector<std::string> keys = keys_of(command);
  if (keys.empty()) return {};
  return function_of(command) + "_keys() {\n  compadd -S = -- " + spaced(keys) + "\n}\n\n";
}

std::string command_function(const Command& command) {
  std::string text = keys_function(command);
  std::vector<const Command*> below;
  for (const Command& one : command.below) below.push_back(&one);
  if (!below.empty()) text += zsh_commands_function(function_of(command) + "_commands", below);
  text += function_of(command) + "() {\n";
  if (!below.empty()) text += hand_on(command);
  text += "  _arguments";
  for (const Option& option : with_phases(command.options))
    for (const std::string& name : option.names) text += " \\\n    " + specification(option, name, command);
  for (const Argument& argument : command.arguments)
    text += " \\\n    " + argument_specification(argument, command, &argument == &command.arguments.front());
  if (command.arguments.empty() && !below.empty())
    text += " \\\n    '1:command:" + function_of(command) + "_commands'";
  return text + "\n}\n\n";
}

}  // namespace

std::string zsh_completion(const Command& program) {
  std::string text =
      "#compdef mesopix\n# Completion of mesopix for zsh, made from the options of the program.\n\n";
  std::vector<const Command*> all = every_command(program);
  text += zsh_commands_function("_mesopix_all_commands", {all.begin() + 1, all.end()});
  for (auto command = all.rbegin(); command != all.rend(); ++command) text += command_function(**command);
  return text + "_mesopix \"$@\"\n";
}

}  // namespace manual
