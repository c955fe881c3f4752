#include "apps/manual/completions.hpp"
#include "apps/manual/expected_value.hpp"

namespace manual {
namespace {

constexpr const char* fish_beginning =
    R"(# Completion of mesopix for fish, made from the options of the program.

# Whether what is typed belongs to the command of this name.
function __mesopix_at
    set -l at mesopix
    for word in (commandline -opc)[2..-1]
        if contains -- "$at $word" $__mesopix_commands
            set at "$at $word"
        end
    end
    test "$at" = "$argv[1]"
end

# Whether an option is typed by the key of its setting.
function __mesopix_by_key
    string match -q -- '*.*' (commandline -ct) (commandline -opc)[-1]
end

# Files with one of the endings, and the folders on the way to them.
function __mesopix_files
    set -l pattern '/$|\.('(string join '|' -- $argv)')$'
    for path in (__fish_complete_path (commandline -ct | string replace -r -- '^-[^=]*=' '') | string split -f 1 \t)
        string match -qri -- $pattern $path; and echo $path
    end
end

)";

std::string fish_quoted(const std::string& text) {
  std::string made = "'";
  for (const char letter : text)
    made += (letter == '\'' || letter == '\\' ? "\\" : "") + std::string(1, letter);
  return made + "'";
}

std::string at(const Command& command) { return "__mesopix_at " + fish_quoted(joined(command, " ")); }

std::string line(const std::string& condition, const std::string& rest) {
  return "complete -c mesopix -n \"" + condition + "\"" + rest + "\n";
}

/// What may be completed, in the words of "complete -a"; empty = nothing, or any file.
std::string candidates(const ExpectedValue& value, const std::vector<std::string>& keys,
                       const Command& program) {
  std::vector<std::string> words = value.words;
  if (value.keys)
    for (const std::string& key : keys) words.push_back(key + "=");
  if (value.commands) words = names_of_commands(program);
  if (value.files && !value.endings.empty())
    words.push_back("(__mesopix_files " + spaced(value.endings) + ")");
  if (value.folders && !value.files) words.emplace_back("(__fish_complete_directories)");
  return spaced(words);
}

/// How "complete" is told what an option waits for.
std::string value_of(const Option& option, const std::vector<std::string>& keys, const Command& program) {
  if (option.type.empty()) return {};
  const ExpectedValue value = expected(option);
  if (value.files && value.endings.empty()) return " -r -F";
  const std::string words = candidates(value, keys, program);
  return " -x" + (words.empty() ? "" : " -a " + fish_quoted(words));
}

std::string names_flags(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    text += name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return text;
}

std::string option_lines(const Command& command, const Command& program) {
  const std::vector<std::string> keys = keys_of(command);
  std::string text;
  for (const Option& option : with_phases(command.options)) {
    const std::string rest = value_of(option, keys, program) + " -d " + fish_quoted(option.help);
    const std::vector<std::string> listed = listed_names(option);
    if (!listed.empty()) text += line(at(command), names_flags(listed) + rest);
    const std::vector<std::string> by_key = names_by_key(option);
    if (!by_key.empty() && by_key != listed)
      text += line(at(command) + "; and __mesopix_by_key", names_flags(by_key) + rest);
  }
  return text;
}

std::string argument_lines(const Command& command, const Command& program) {
  std::string text;
  for (const Command& below : command.below)
    text += line(at(command), " -a " + below.words.back() + " -d " + fish_quoted(below.description));
  for (const Argument& argument : command.arguments) {
    const ExpectedValue value = expected(argument);
    const std::string words = candidates(value, {}, program);
    if (!words.empty())
      text += line(at(command), " -a " + fish_quoted(words));
    else if (value.files)
      text += line(at(command), " -F");
  }
  return text;
}

}  // namespace

std::string fish_completion(const Command& program) {
  std::string text = fish_beginning + std::string("set -g __mesopix_commands");
  for (const Command* command : every_command(program))
    if (command != &program) text += " " + fish_quoted(joined(*command, " "));
  text += "\n\ncomplete -c mesopix -f\n";
  for (const Command* command : every_command(program))
    text += argument_lines(*command, program) + option_lines(*command, program);
  return text;
}

}  // namespace manual
