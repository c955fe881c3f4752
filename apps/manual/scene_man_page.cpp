#include <sstream>

#include "apps/manual/man_pages.hpp"
#include "apps/manual/roff.hpp"
#include "apps/manual/setting_words.hpp"

namespace manual {
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
    page.item(bold(app::leaf_of(setting.key)) + " " + italic(setting.type), described(setting));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::string scene_man_page(const std::string& scene) {
  ManPage page("mesopix-scene", 5, "scene files of mesopix");
  page.section("DESCRIPTION");
  for (const std::string& paragraph : about_scenes()) page.paragraph(roff(paragraph));
  write_types(page);
  page.section("TABLES AND KEYS");
  for (const TableWords& table : scene_tables()) write_table(page, table);
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
