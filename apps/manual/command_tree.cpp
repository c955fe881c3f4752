#include "apps/manual/command_tree.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include "apps/command/command_line.hpp"

namespace manual {
namespace {

constexpr const char* blanks = "  ";

std::string without_blanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? std::string() : text.substr(first);
}

/// A line of columns; what stands in the third one follows that in the second behind a colon.
std::optional<Item> item_in(const std::string& line) {
  const std::string text = without_blanks(line);
  const std::size_t gap = text.find(blanks);
  if (gap == std::string::npos) return std::nullopt;
  std::string rest = without_blanks(text.substr(gap));
  if (const std::size_t second = rest.find(blanks); second != std::string::npos)
    rest.replace(second, std::string::npos, ": " + without_blanks(rest.substr(second)));
  return Item{text.substr(0, gap), rest};
}

bool goes_on(const std::vector<Passage>& passages, const std::string& line) {
  constexpr const char* deep = "      ";
  return !passages.empty() && !passages.back().items.empty() && line.rfind(deep, 0) == 0;
}

/// Where more of the same kind goes: into the last passage, or into a new one.
template <class Part>
Part& last(std::vector<Passage>& passages, Part Passage::*part) {
  if (passages.empty() || (passages.back().*part).empty()) passages.emplace_back();
  return passages.back().*part;
}

void append_text(std::vector<Passage>& passages, const std::string& line) {
  std::string& text = last(passages, &Passage::text);
  text += (text.empty() ? "" : " ") + line;
}

void append_note(std::vector<Passage>& notes, const std::string& line) {
  if (goes_on(notes, line))
    notes.back().items.back().text += " " + without_blanks(line);
  else if (const auto item = item_in(line))
    last(notes, &Passage::items).push_back(*item);
  else if (line.rfind(blanks, 0) == 0)
    last(notes, &Passage::verbatim).push_back(line.substr(2));
  else
    append_text(notes, line);
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

HelpText help_text(const std::string& footer) {
  HelpText text;
  bool examples = false;
  for (const std::string& line : lines_of(footer)) {
    examples = examples || line.rfind("Example", 0) == 0;
    if (!examples)
      append_note(text.notes, line);
    else if (line.rfind(blanks, 0) == 0)
      last(text.examples, &Passage::verbatim).push_back(line.substr(2));
    else
      append_text(text.examples, line);
  }
  return text;
}

namespace {

Option option_of(const CLI::App& app, const CLI::Option& option) {
  Option made{
      app::names_of(option), {}, app::form_of(app, option), option.get_description(), option.get_group()};
  if (made.names.size() > 1 && made.names.back().find('.') != std::string::npos) {
    made.by_key = made.names.back();
    made.names.pop_back();
  }
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
    else if (!option->get_group().empty())
      made.options.push_back(option_of(app, *option));
  for (const Option& option : made.options)
    if (option.names.front() == "--set") made.keys = option.form.hints;
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
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end()) groups.push_back(option.group);
  return groups;
}

std::string option_by_key(const Command& command) {
  const std::string& key = command.keys.back();
  return "--" + app::with_dashes(key.substr(0, key.find('=')));
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
