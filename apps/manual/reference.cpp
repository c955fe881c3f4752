#include "apps/manual/reference.hpp"

#include "apps/command/command.hpp"
#include "apps/manual/command_tree.hpp"
#include "apps/manual/setting_words.hpp"

namespace manual {
namespace {

/// Text that neither Markdown nor HTML takes for markup, in a cell of a table too.
std::string plain(const std::string& text) {
  std::string made;
  for (const char letter : text) {
    if (letter == '<')
      made += "&lt;";
    else if (letter == '&')
      made += "&amp;";
    else if (letter == '|')
      made += "&#124;";
    else if (std::string("\\`*_[]").find(letter) != std::string::npos)
      made += std::string("\\") + letter;
    else
      made += letter;
  }
  return made;
}

/// Of the two ways to write code the one that keeps a bar, where cells of tables end at bars.
std::string code(const std::string& text) {
  if (text.empty()) return {};
  return text.find('|') == std::string::npos ? "`" + text + "`" : "<code>" + plain(text) + "</code>";
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

std::string table_head(const std::vector<std::string>& cells) {
  return row(cells) + row(std::vector<std::string>(cells.size(), "---"));
}

std::string fenced(const char* language, const std::string& text) {
  return std::string("```") + language + "\n" + text + "```\n\n";
}

std::string markdown(const Passage& passage, const char* language) {
  if (!passage.text.empty()) return plain(passage.text) + "\n\n";
  std::string text;
  for (const Item& item : passage.items) text += "- " + code(item.term) + ": " + plain(item.text) + "\n";
  if (!text.empty()) return text + "\n";
  for (const std::string& line : passage.verbatim) text += line + "\n";
  return fenced(language, text);
}

std::string markdown(const std::vector<Passage>& passages, const char* language) {
  std::string text;
  for (const Passage& passage : passages) text += markdown(passage, language);
  return text;
}

/// Those that the help lists, with the type, then the one by the key.
std::string names_of(const Option& option) {
  std::vector<std::string> names = option.names;
  if (const std::string type = app::type(option.form); !type.empty()) names.back() += " " + type;
  if (!option.by_key.empty()) names.push_back(option.by_key);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + code(name);
  return text;
}

std::string options_table(const Command& command, const std::string& group) {
  std::string text = "**" + plain(group) + "**\n\n" + table_head({"Option", "Meaning"});
  for (const Option& option : command.options)
    if (option.group == group) text += row({names_of(option), plain(option.help)});
  return text + "\n";
}

std::string arguments_table(const Command& command) {
  if (command.arguments.empty()) return {};
  std::string text = table_head({"Argument", "Meaning"});
  for (const Argument& argument : command.arguments)
    text +=
        row({code(argument.name) + (argument.optional ? " (may be left out)" : ""), plain(argument.help)});
  return text + "\n";
}

std::string command_section(const Command& command) {
  const std::string level(command.words.size(), '#');
  const HelpText text = help_text(command.footer);
  std::string page = level + " " + joined(command, " ") + "\n\n" + plain(command.description) + ".\n\n";
  page += fenced("text", synopsis(command) + "\n") + markdown(text.notes, "text") + arguments_table(command);
  for (const std::string& group : option_groups(command)) page += options_table(command, group);
  if (!command.keys.empty())
    page += "Every setting of a scene that the command takes is also an option by its key, as " +
            code(option_by_key(command)) + ", and may be given with " + code("--set") +
            "; the keys are those of [scene files](scene.md).\n\n";
  return page + markdown(text.examples, "sh");
}

std::string list_of_commands(const Command& program) {
  std::string text;
  std::string group;
  for (const Command* command : every_command(program)) {
    if (command == &program) continue;
    if (command->words.size() == 2 && command->group != group) {
      group = command->group;
      text += "\n" + plain(group) + ":\n\n";
    }
    std::string anchor = joined(*command, "-");
    text += std::string(command->words.size() == 3 ? "    " : "") + "- [" + joined(*command, " ") + "](#" +
            anchor + "): " + plain(command->description) + "\n";
  }
  return text.substr(1) + "\n";
}

std::string setting_row(const SettingWords& setting) {
  std::string allowed = plain(setting.allowed);
  return row(
      {code(setting.key), code(setting.type), code(setting.default_value), allowed, plain(setting.help)});
}

}  // namespace

std::string commands_page(const Command& program) {
  std::string page = "# Commands\n\n" + list_of_commands(program);
  page += "Every command has " + code("--help") + ". On terminals errors are red and headings bold, unless " +
          code("NO_COLOR") + " is set or " + code("TERM") + " is " + code("dumb") +
          "; what the program computes depends on nothing in its environment.\n\n";
  for (const Command* command : every_command(program))
    if (command != &program) page += command_section(*command);
  page.pop_back();
  return page;
}

std::string scene_page(const std::string& scene) {
  std::string page = "# Scene files\n\n";
  for (const std::string& paragraph : about_scenes()) page += plain(paragraph) + "\n\n";
  page += fenced("toml", scene) + "## Quantities\n\n" + table_head({"Type", "Units", "Example"});
  for (const TypeWords& type : quantity_types())
    page += row({code(type.name), plain(type.units), code(type.example)});
  page += row({code("N"), "", "a whole number, " + code("20")}) + "\n";
  for (const TableWords& table : scene_tables()) {
    page += "## `[" + table.name + "]`: " + plain(table.title) + "\n\n" +
            table_head({"Key", "Type", "Default", "Allowed", "Meaning"});
    for (const SettingWords& setting : table.settings) page += setting_row(setting);
    page += "\n";
  }
  for (const TableWords& list : list_tables()) {
    page += "## `[" + list.name + "]`\n\n" + plain(list.title) + "\n\n" +
            table_head({"Key", "Type", "Default", "Allowed", "Meaning"});
    for (const SettingWords& setting : list.settings) page += setting_row(setting);
    page += "\n";
  }
  return page + "## `[[ellipses]]`\n\n" + plain(about_ellipses()) + "\n";
}

std::string exit_codes_page() {
  std::string page = "# Exit codes\n\n" + table_head({"Code", "Name in sysexits.h", "Meaning"});
  for (const app::ExitMeaning& meaning : app::exit_meanings())
    page += row({std::to_string(static_cast<int>(meaning.code)), code(meaning.name), plain(meaning.whole)});
  return page;
}

std::vector<File> reference(const Command& program, const std::string& scene) {
  return {{"commands.md", commands_page(program)},
          {"scene.md", scene_page(scene)},
          {"exit_codes.md", exit_codes_page()}};
}

}  // namespace manual
