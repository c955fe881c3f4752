#include "apps/manual/completions.hpp"

#include <map>

#include "apps/manual/expected_value.hpp"

namespace manual {

std::vector<File> completions(const Command& program) {
  return {{"mesopix.bash", bash_completion(program)},
          {"_mesopix", zsh_completion(program)},
          {"mesopix.fish", fish_completion(program)}};
}

namespace {

constexpr const char* beginning = R"(# Completion of mesopix for bash, made from the options of the program.

# Words that begin as what is typed does.
_mesopix_words() {
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$1" -- "$cur")
}

# Keys of settings, each with the = that its value stands behind.
_mesopix_keys() {
  compopt -o nospace 2>/dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -S = -W "$1" -- "$cur")
}

_mesopix_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$cur")
}

# Files with one of the endings, or any, and the folders on the way to them.
_mesopix_files() {
  local ending
  compopt -o filenames 2>/dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
    if [[ $# -eq 0 ]]; then
      compgen -f -- "$cur"
    else
      compgen -d -- "$cur"
      for ending; do
        compgen -f -X "!*.$ending" -- "$cur"
        compgen -f -X "!*.${ending^^}" -- "$cur"
      done
    fi
  )
}
)";

constexpr const char* ending = R"(
_mesopix() {
  local cur=${COMP_WORDS[COMP_CWORD]} at=$((COMP_CWORD - 1)) command=mesopix option i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    _mesopix_is_command "$command ${COMP_WORDS[i]}" && command+=" ${COMP_WORDS[i]}"
  done
  [[ ${COMP_WORDS[at]} == = ]] && ((at--))  # a word of its own in --option=value
  option=${COMP_WORDS[at]}
  [[ ${COMP_WORDS[at + 1]} == = && ${COMP_WORDS[at - 1]} == --set ]] && option=--${option//_/-}  # --set key=value
  [[ $cur == = ]] && cur=
  _mesopix_value "$command" "$option" && return
  if [[ $cur == -* ]]; then
    _mesopix_options "$command"
    [[ $cur == *.* ]] && _mesopix_options_by_key "$command"
  else
    _mesopix_arguments "$command"
  fi
  return 0
}

complete -F _mesopix mesopix
)";

std::string quoted(const std::string& text) { return "'" + text + "'"; }

std::string action(const ExpectedValue& value, const std::vector<std::string>& keys, const Command& program) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  if (!value.words.empty()) add("_mesopix_words " + quoted(spaced(value.words)));
  if (value.keys) add("_mesopix_keys " + quoted(spaced(keys)));
  if (value.commands) add("_mesopix_words " + quoted(spaced(names_of_commands(program))));
  if (value.files) add("_mesopix_files" + (value.endings.empty() ? "" : " " + spaced(value.endings)));
  if (value.folders && !value.files) add("_mesopix_folders");
  return text.empty() ? ":" : text;
}

std::string case_line(const std::string& pattern, const std::string& does) {
  return "    " + pattern + ") " + does + " ;;\n";
}

/// Options of one command that wait for the same.
std::string value_cases(const Command& command, const Command& program) {
  std::map<std::string, std::string> patterns;  // by action
  const std::vector<std::string> keys = keys_of(command);
  for (const Option& option : with_phases(command.options))
    for (const std::string& name : option.names) {
      if (option.type.empty()) continue;
      std::string& pattern = patterns[action(expected(option), keys, program)];
      pattern += (pattern.empty() ? "" : " | ") + quoted(joined(command, " ") + " " + name);
    }
  std::string text;
  for (const auto& [does, pattern] : patterns) text += case_line(pattern, does);
  return text;
}

/// A function with a case for every command.
template <class Line>
std::string by_command(const std::string& name, const Command& program, const Line& line) {
  std::string text = "\n" + name + "() {\n  case \"$1\" in\n";
  for (const Command* command : every_command(program))
    if (const std::string does = line(*command); !does.empty())
      text += case_line(quoted(joined(*command, " ")), does);
  return text + "  esac\n}\n";
}

std::string argument_action(const Command& command, const Command& program) {
  std::string text;
  if (!command.below.empty()) text = "_mesopix_words " + quoted(spaced(names_below(command)));
  for (const Argument& argument : command.arguments) {
    const std::string does = action(expected(argument), {}, program);
    if (does != ":") text += (text.empty() ? "" : "; ") + does;
  }
  return text;
}

std::string options_action(const Command& command, std::vector<std::string> (*names_of)(const Option&)) {
  std::vector<std::string> names;
  for (const Option& option : with_phases(command.options))
    for (const std::string& name : names_of(option)) names.push_back(name);
  return names.empty() ? "" : "_mesopix_words " + quoted(spaced(names));
}

std::string commands_function(const Command& program) {
  std::string pattern;
  for (const Command* command : every_command(program))
    if (command != &program) pattern += (pattern.empty() ? "" : " | ") + quoted(joined(*command, " "));
  return "\n_mesopix_is_command() {\n  case \"$1\" in\n    " + pattern +
         ") ;;\n    *) return 1 ;;\n  esac\n}\n";
}

}  // namespace

std::string bash_completion(const Command& program) {
  std::string text = beginning + commands_function(program);
  text +=
      "\n# What an option waits for; fails where it waits for nothing.\n_mesopix_value() {\n  case \"$1 $2\" "
      "in\n";
  for (const Command* command : every_command(program)) text += value_cases(*command, program);
  text += "    *) return 1 ;;\n  esac\n}\n";
  text += by_command("_mesopix_options", program,
                     [](const Command& command) { return options_action(command, listed_names); });
  text += by_command("_mesopix_options_by_key", program,
                     [](const Command& command) { return options_action(command, names_by_key); });
  text += by_command("_mesopix_arguments", program,
                     [&](const Command& command) { return argument_action(command, program); });
  return text + ending;
}

}  // namespace manual
