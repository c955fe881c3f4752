#include "apps/command/completion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "apps/command/command_line.hpp"

namespace app {
namespace {

using Words = std::vector<std::string>;

std::string line_of(const std::string& word, const std::string& help = {}) {
  return word + (help.empty() ? "" : "\t" + help) + "\n";
}

/// The command that the words name, those below others too.
const CLI::App& deepest(const CLI::App& program, const Words& words) {
  const CLI::App* command = &program;
  for (const std::string& word : words)
    for (const CLI::App* below :
         command->get_subcommands([&](const CLI::App* one) { return one->get_name() == word; }))
      command = below;
  return *command;
}

/// What waits for a value: an option, or the property of a phase.
std::optional<Form> form_named(const CLI::App& command, const std::string& option) {
  if (const CLI::Option* found = command.get_option_no_throw(option)) return form_of(command, *found);
  const std::string key = phase_key(option.substr(std::min(option.size(), option.find_first_not_of('-'))));
  return key.empty() ? std::nullopt : std::optional(find_field(key)->form);
}

/// What the word at the cursor, or what stands behind its =, is the value of.
std::optional<Form> awaited(const CLI::App& command, const Words& before, const std::string& word) {
  std::string option = before.empty() ? std::string() : before.back();
  const std::size_t equals = word.find('=');
  if (equals != std::string::npos)
    option = (option == "--set" ? "--" : "") + with_dashes(word.substr(0, equals));
  if (!option.starts_with('-')) return std::nullopt;
  const std::optional<Form> form = form_named(command, option);
  if (!form || form->kind != Kind::boolean) return form;
  return equals == std::string::npos ? std::nullopt : std::optional(one_of({"true", "false"}));
}

std::string lines_of(const Form& form) {
  std::string lines;
  for (const Words& words : {form.words, form.hints})
    for (const std::string& word : words) lines += line_of(word);
  if (form.kind == Kind::folder) lines += "@folders\n";
  if (form.kind != Kind::path) return lines;
  lines += "@files";
  for (const std::string& ending : form.endings) lines += " " + ending;
  return lines + "\n";
}

/// Options by their names, with phases of concrete in place of PHASE, each once, but for those that add up.
class OptionLines {
 public:
  OptionLines(const Words& before, bool by_key) : before_(before), by_key_(by_key) {}

  void add(const CLI::Option& option) {
    constexpr const char* of_phases = "--PHASE.";
    const Words names = names_of(option);
    const std::string& help = option.get_description();
    if (names.front().starts_with(of_phases))
      for (const mpm::Phase& phase : Settings().phases)
        add({"--" + phase.name + names.front().substr(names.front().find('.'))}, help + " of " + phase.name,
            true);
    else if (may_be_given(option, names))
      add(names, help, !option.get_group().empty());
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  /// A setting takes all of its values too, to refuse a second one with its name; those have a key, with a
  /// dot.
  [[nodiscard]] bool may_be_given(const CLI::Option& option, const Words& names) const {
    const bool adds_up = names.back().find('.') == std::string::npos &&
                         (option.get_items_expected_max() > 1 ||
                          option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll);
    return adds_up ||
           std::find_first_of(before_.begin(), before_.end(), names.begin(), names.end()) == before_.end();
  }

  void add(const Words& names, const std::string& help, bool in_help) {
    for (const std::string& name : names)
      if (by_key_ || (in_help && (name.find('.') == std::string::npos || &name == &names.front())))
        text_ += line_of(name, help);
  }

  const Words& before_;
  bool by_key_;  ///< what is typed has a dot: settings that the help does not show have names too
  std::string text_;
};

/// Commands below, and what the arguments may be.
std::string argument_lines(const CLI::App& command) {
  std::string lines;
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
    lines += line_of(below->get_name(), below->get_description());
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) lines += lines_of(form_of(command, *option));
  return lines;
}

}  // namespace

std::string completions(const CLI::App& program, const std::vector<std::string>& words) {
  const std::string word = words.empty() ? std::string() : words.back();
  const Words before(words.begin(), words.end() - (words.empty() ? 0 : 1));
  const CLI::App& command = deepest(program, before);
  if (const std::optional<Form> form = awaited(command, before, word)) return lines_of(*form);
  if (!word.starts_with('-')) return argument_lines(command);
  OptionLines options(before, word.find('.') != std::string::npos);
  for (const CLI::Option* option : command.get_options())
    if (!option->get_positional()) options.add(*option);
  return options.text();
}

}  // namespace app
