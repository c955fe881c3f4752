#include "apps/manual/man_pages.hpp"

#include <sstream>

#include "apps/command/command.hpp"
#include "apps/manual/command_tree.hpp"
#include "apps/manual/setting_words.hpp"
#include "apps/text/version.hpp"
#include "apps/text/words.hpp"

namespace manual {
namespace {

std::string escaped(char letter) {
  switch (letter) {
    case '\\':
      return "\\e";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return std::string(1, letter);
  }
}

/// In lines of less than 80 letters, none of which is a request; roff fills them anew.
std::string wrapped(const std::string& formatted) {
  constexpr std::size_t longest = 78;
  std::string text;
  std::size_t line = 0;
  std::istringstream words(formatted);
  for (std::string word; words >> word;) {
    const bool breaks = line > 0 && line + 1 + word.size() > longest;
    if (line > 0) text += breaks ? "\n" : " ";
    if (breaks && word.front() == '.') text += "\\&";
    line = breaks || line == 0 ? word.size() : line + 1 + word.size();
    text += word;
  }
  return text + "\n";
}

std::string heading(const std::string& name, int section, const std::string& about) {
  const std::string shelf = section == 1 ? "User Commands" : "File Formats";
  return ".TH " + app::upper(roff(name)) + " " + std::to_string(section) + " \"\" \"mesopix " +
         app::version() + "\" \"" + shelf + "\"\n.SH NAME\n" + roff(name) + " \\- " + roff(about) + "\n";
}

}  // namespace

std::string roff(const std::string& text) {
  std::string made = !text.empty() && text.front() == '.' ? "\\&" : "";  // else it would be a request
  for (const char letter : text) made += escaped(letter);
  return made;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }

std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

ManPage::ManPage(const std::string& name, int section, const std::string& about)
    : text_(heading(name, section, about)) {}

void ManPage::section(const std::string& title) {
  text_ += ".SH " + roff(title) + "\n";
  fresh_ = true;
}

void ManPage::subsection(const std::string& title) {
  text_ += ".SS " + roff(title) + "\n";
  fresh_ = true;
}

void ManPage::paragraph(const std::string& formatted) {
  text_ += (fresh_ ? "" : ".PP\n") + wrapped(formatted);
  fresh_ = false;
}

void ManPage::item(const std::string& term, const std::string& formatted) {
  text_ += ".TP\n" + term + "\n" + (formatted.empty() ? "\\&\n" : wrapped(formatted));
  fresh_ = false;
}

void ManPage::verbatim(const std::vector<std::string>& lines) {
  text_ += fresh_ ? "" : ".PP\n";
  text_ += ".RS 4\n.nf\n";
  for (const std::string& line : lines) text_ += (line.empty() ? "\\&" : roff(line)) + "\n";
  text_ += ".fi\n.RE\n";
  fresh_ = false;
}

namespace {

constexpr const char* general = "Options";  // heading of the options that belong to no group

std::string term_of(const Option& option) {
  std::string term;
  for (const std::string& name : option.names) term += (term.empty() ? "" : ", ") + bold(name);
  const std::string type = app::type(option.form);
  return type.empty() ? term : term + " " + italic(type);
}

void write(ManPage& page, const std::vector<Passage>& passages) {
  for (const Passage& passage : passages) {
    if (!passage.text.empty()) page.paragraph(roff(passage.text));
    if (!passage.verbatim.empty()) page.verbatim(passage.verbatim);
    for (const Item& item : passage.items) page.item(bold(item.term), roff(item.text));
  }
}

void write_synopsis(ManPage& page, const Command& command) {
  page.section("SYNOPSIS");
  page.paragraph(bold(joined(command, " ")) + roff(synopsis(command).substr(joined(command, " ").size())));
  if (!command.below.empty()) page.paragraph(bold(joined(command, " ")) + " " + italic("COMMAND") + " ...");
}

void write_commands(ManPage& page, const Command& command) {
  if (command.below.empty()) return;
  page.section("COMMANDS");
  std::string group;
  for (const Command& below : command.below) {
    if (below.group != group && below.group != "Subcommands") page.subsection(below.group);
    group = below.group;
    page.item(bold(joined(below, "-")) + "(1)", roff(below.description));
  }
}

void write_arguments(ManPage& page, const Command& command) {
  if (command.arguments.empty()) return;
  page.section("ARGUMENTS");
  for (const Argument& argument : command.arguments)
    page.item(italic(argument.name) + (argument.repeatable ? " ..." : ""), roff(argument.help));
}

void write_options(ManPage& page, const Command& command) {
  page.section("OPTIONS");
  for (const std::string& group : option_groups(command)) {
    if (group != general) page.subsection(group);
    for (const Option& option : command.options)
      if (option.group == group) page.item(term_of(option), roff(option.help));
  }
  if (command.keys.empty()) return;
  page.subsection("Settings by their keys");
  page.paragraph("Every setting of a scene that the command takes is also an option by its key, as " +
                 bold(option_by_key(command)) + ", and may be given with " + bold("--set") +
                 ". The keys are those of " + bold("mesopix-scene") + "(5). In names of options " +
                 bold("-") + " and " + bold("_") + " are the same.");
}

void write_exit_status(ManPage& page) {
  page.section("EXIT STATUS");
  for (const app::ExitMeaning& meaning : app::exit_meanings())
    page.item(bold(std::to_string(static_cast<int>(meaning.code))), roff(meaning.whole));
}

void write_environment(ManPage& page) {
  page.section("ENVIRONMENT");
  page.item(bold("NO_COLOR"), "Where it is set and not empty, nothing is coloured.");
  page.item(bold("TERM"), "Where it is " + bold("dumb") + ", nothing is coloured, and no progress is drawn.");
  page.paragraph(
      "Both are about terminals alone. What the program computes depends on nothing but its options and "
      "files.");
}

/// The pages of the program, of the commands beside and below this one, and of scenes.
void write_see_also(ManPage& page, const Command& command, const Command& program) {
  page.section("SEE ALSO");
  std::string text;
  const auto add = [&](const std::string& name, const char* section) {
    text += (text.empty() ? "" : ",\n") + bold(name) + section;
  };
  for (const Command* one : every_command(program)) {
    const bool far = one->words.size() > 2 && command.words.size() > 1 && one->words[1] != command.words[1];
    if (one != &command && !far) add(joined(*one, "-"), "(1)");
  }
  add("mesopix-scene", "(5)");
  page.paragraph(text);
}

}  // namespace

std::string command_man_page(const Command& command, const Command& program) {
  const bool whole = command.words.size() == 1;
  std::string about = command.description;
  if (const std::size_t colon = about.find(": "); whole && colon != std::string::npos)
    about.erase(0, colon + 2);
  ManPage page(joined(command, "-"), 1, about);
  write_synopsis(page, command);
  const HelpText text = help_text(command.footer);
  page.section("DESCRIPTION");
  page.paragraph(roff(output::capitalised(about)) + ".");
  write(page, text.notes);
  write_commands(page, command);
  write_arguments(page, command);
  write_options(page, command);
  if (!text.examples.empty()) {
    page.section("EXAMPLES");
    write(page, text.examples);
  }
  if (whole) write_environment(page);
  write_exit_status(page);
  write_see_also(page, command, program);
  return page.text();
}

std::vector<File> man_pages(const Command& program, const std::string& scene) {
  std::vector<File> pages;
  for (const Command* command : every_command(program))
    pages.push_back({joined(*command, "-") + ".1", command_man_page(*command, program)});
  pages.push_back({"mesopix-scene.5", scene_man_page(scene)});
  return pages;
}

namespace {

std::string described(const SettingWords& setting) {
  std::string text = roff(setting.help) + ".";
  if (!setting.allowed.empty()) text += " Allowed: " + roff(setting.allowed) + ".";
  if (!setting.default_value.empty()) text += " Default: " + roff(setting.default_value) + ".";
  return text;
}

void write_types(ManPage& page) {
  page.section("QUANTITIES");
  for (const TypeWords& type : quantity_types())
    page.item(italic(type.name), "Units: " + roff(type.units) + ". Example: \"" + roff(type.example) + "\".");
  page.item(italic("N"), "A whole number.");
  page.paragraph("Words that a type shows in small letters, as " + bold("auto") +
                 ", stand for themselves, in quotes.");
}

void write_table(ManPage& page, const TableWords& table) {
  page.subsection("[" + table.name + "]: " + table.title);
  for (const SettingWords& setting : table.settings)
    page.item(bold(setting.key) + " " + italic(setting.type), described(setting));
}

}  // namespace

std::string scene_man_page(const std::string& scene) {
  ManPage page("mesopix-scene", 5, "scene files of mesopix");
  page.section("DESCRIPTION");
  for (const std::string& paragraph : about_scenes()) page.paragraph(roff(paragraph));
  write_types(page);
  page.section("TABLES AND KEYS");
  for (const TableWords& table : scene_tables()) write_table(page, table);
  for (const TableWords& list : list_tables()) write_table(page, list);
  page.subsection("[[ellipses]]");
  page.paragraph(roff(about_ellipses()));
  page.section("EXAMPLE");
  page.verbatim(lines_of(scene));
  page.section("SEE ALSO");
  page.paragraph(bold("mesopix-simulate") + "(1),\n" + bold("mesopix-generate") + "(1),\n" +
                 bold("mesopix-convert") + "(1),\n" + bold("mesopix-calibrate") + "(1),\n" +
                 bold("mesopix-study") + "(1)");
  return page.text();
}

}  // namespace manual
