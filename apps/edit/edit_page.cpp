#include "apps/edit/edit_page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/drawing/colours.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/settings/offer.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"
#include "specimen/convert/strokes.hpp"

namespace app {
namespace {

using output::capitalised;
using output::escape;

struct Tool {
  const char* id;
  const char* key;  ///< on the keyboard
  const char* name;
  const char* brief;  ///< for the reader who points at it
};

std::string tool_button(const Tool& tool, const std::string& colour) {
  const std::string dot = colour.empty() ? "" : fmt::format("<i style=\"background:{}\"></i>", colour);
  return fmt::format(
      "<button type=\"button\" class=\"tool\" data-tool=\"{}\" data-key=\"{}\" aria-pressed=\"false\" "
      "title=\"{}\">{}{} <kbd>{}</kbd></button>\n",
      tool.id, tool.key, escape(tool.brief), dot, escape(tool.name), tool.key);
}

std::string phase_buttons() {
  using specimen::phase_colour;
  std::string html;
  const auto add = [&](const Tool& tool, specimen::Rgb colour) {
    html += tool_button(tool, output::hex(colour));
  };
  add({"aggregate", "1", "aggregate", "Show what aggregate looks like"},
      phase_colour(specimen::phase::aggregate));
  add({"mortar", "2", "mortar", "Show what mortar looks like"}, phase_colour(specimen::phase::mortar));
  add({"void", "3", "void", "Show what a void looks like"}, phase_colour(specimen::phase::void_));
  return html +
         "<span id=\"own-phases\"></span>\n"
         "<button type=\"button\" id=\"add-phase\" title=\"A phase with a name of your own\">+</button>\n";
}

std::string other_tools() {
  return tool_button({"cut", "c", "cut", "Draw a boundary: it parts an aggregate in two"},
                     output::hex(specimen::cut_colour)) +
         tool_button({"one-grain", "g", "one grain", "All pieces that the stroke crosses are one aggregate"},
                     output::hex(specimen::one_grain_colour)) +
         tool_button({"erase", "e", "erase", "Remove the strokes that you touch, cuts too"}, "") +
         tool_button({"pan", "h", "move", "Move the picture; the space bar does it with every tool"}, "") +
         tool_button({"ruler", "r", "ruler", "Click two points and say how far they are apart"}, "");
}

std::string button(const char* id, const char* name, const char* key, const char* title) {
  return fmt::format("<button type=\"button\" id=\"{}\" title=\"{}\">{}{}</button>\n", id, title, name,
                     *key == '\0' ? std::string() : fmt::format(" <kbd>{}</kbd>", key));
}

std::string slider(const char* id, const char* name, int low, int high, int value, const char* key) {
  return fmt::format(
      "<label>{0}{5} <input type=\"range\" id=\"{1}\" min=\"{2}\" max=\"{3}\" value=\"{4}\"/>"
      "<output id=\"{1}-value\"></output></label>\n",
      name, id, low, high, value, *key == '\0' ? std::string() : fmt::format(" <kbd>{}</kbd>", key));
}

std::string bars() {
  return "<div class=\"bar\" role=\"toolbar\" aria-label=\"Strokes\">\n" + phase_buttons() +
         "<span class=\"gap\"></span>\n" + other_tools() +
         "</div>\n<div class=\"bar\" role=\"toolbar\" aria-label=\"View\">\n" +
         button("undo", "Undo", "Ctrl Z", "Take the last change back") +
         button("redo", "Redo", "Ctrl Y", "Do it again") +
         button("zoom-in", "+", "", "Larger (key +, or the wheel)") +
         button("zoom-out", "&#8722;", "", "Smaller (key -, or the wheel)") +
         button("fit", "Fit", "0", "The whole picture") + slider("brush", "Brush", 1, 100, 9, "[ ]") +
         slider("opacity", "Mask", 0, 100, 45, "M") +
         "<label><input type=\"checkbox\" id=\"show-uncertain\" checked=\"checked\"/> uncertain "
         "<kbd>U</kbd></label>\n"
         "<label><input type=\"checkbox\" id=\"show-strokes\" checked=\"checked\"/> strokes "
         "<kbd>S</kbd></label>\n"
         "</div>\n";
}

struct Control {
  const char* key;
  const char* name;
  const char* unit;  ///< beside its field
};

/// Settings of the page, in words; their texts, types and help are those of the schema.
constexpr Control controls[] = {
    {"convert.width", "Width of the picture", ""},
    {"convert.pixels", "Columns of the specimen", "px"},
    {"convert.even_light", "Even out the light", ""},
    {"convert.smooth", "Smooth along edges", "px"},
    {"convert.drop_islands", "Drop islands below", ""},
    {"convert.fill_holes", "Fill holes in aggregates", ""},
    {"convert.open", "Open aggregates", "px"},
    {"convert.close", "Close aggregates", "px"},
    {"convert.split_touching", "Split at necks", ""},
    {"convert.split_depth", "Depth of a neck", ""},
};

std::string control(const Control& one, const Settings& settings) {
  const Field field = *find_field(one.key);
  const std::string title = escape(capitalised(field.help));
  if (field.form.kind == Kind::boolean)
    return fmt::format(
        "<label class=\"setting\" title=\"{}\"><span>{}</span><input type=\"checkbox\" "
        "data-key=\"{}\"/></label>\n",
        title, one.name, one.key);
  return fmt::format(
      "<label class=\"setting\" title=\"{}\"><span>{}</span><input type=\"text\" data-key=\"{}\" "
      "value=\"{}\" "
      "placeholder=\"{}\"/><span class=\"unit\">{}</span></label>\n",
      title + " (" + escape(text(field.form)) + ")", one.name, one.key,
      escape(text_of_setting(one.key, settings)), escape(text_of_setting(one.key, Settings())), one.unit);
}

std::string side(const Settings& settings) {
  std::string html =
      "<aside>\n<section><h2>What was found</h2>\n<p id=\"status\" role=\"status\">Loading …</p>\n"
      "<table class=\"facts\"><tbody id=\"figures\"></tbody></table>\n"
      "<figure class=\"chart\"><svg id=\"sieve\" viewBox=\"0 0 300 170\" role=\"img\" "
      "aria-label=\"Sieve curve\" hidden=\"hidden\"></svg></figure></section>\n"
      "<section><h2>Settings</h2>\n<form id=\"settings\">\n";
  for (const Control& one : controls) html += control(one, settings);
  html +=
      "</form>\n</section>\n<section><h2>Specimen</h2>\n"
      "<p><button type=\"button\" id=\"make\" class=\"main\">Make the specimen</button>\n"
      "<button type=\"button\" id=\"finish\">Finish</button></p>\n<p id=\"made\" role=\"status\"></p>\n"
      "<pre id=\"command\" hidden=\"hidden\"></pre>\n</section>\n";
  html +=
      "<section><details id=\"notes\"><summary>Notes</summary><ul class=\"notes\" "
      "id=\"note-list\"></ul></details>\n"
      "<details><summary>Keys, mouse, touch</summary>\n<ul class=\"notes\">\n"
      "<li>Draw with the mouse, a pen or one finger.</li>\n"
      "<li>The wheel zooms. Move with the space bar or the middle button held, or with two fingers.</li>\n"
      "<li><kbd>1</kbd> to <kbd>9</kbd> choose a phase; <kbd>C</kbd> cut, <kbd>G</kbd> one grain, "
      "<kbd>E</kbd> erase, "
      "<kbd>H</kbd> move, <kbd>R</kbd> ruler.</li>\n"
      "<li><kbd>[</kbd> <kbd>]</kbd> size of the brush; <kbd>M</kbd> mask, <kbd>U</kbd> uncertain pixels, "
      "<kbd>S</kbd> "
      "strokes on and off; <kbd>0</kbd> the whole picture.</li>\n"
      "<li><kbd>Ctrl Z</kbd> undo, <kbd>Ctrl Y</kbd> redo, <kbd>Esc</kbd> leaves a stroke or the "
      "ruler.</li>\n"
      "</ul></details>\n<p class=\"kept\">Your strokes are kept in <code "
      "id=\"file\"></code></p></section>\n</aside>\n";
  return html;
}

std::string colours_json() {
  nlohmann::ordered_json colours = nlohmann::ordered_json::array();
  for (int label = 0; label < 256; ++label)
    colours.push_back(output::hex(specimen::phase_colour(static_cast<std::uint8_t>(label))));
  return nlohmann::ordered_json{{"colours", colours},
                                {"cut", output::hex(specimen::cut_colour)},
                                {"one_grain", output::hex(specimen::one_grain_colour)}}
      .dump();
}

}  // namespace

std::string text_of_setting(std::string_view key, const Settings& settings) {
  const Value value = find_field(key)->get(settings);
  const auto* words = std::get_if<std::string>(&value.data);
  return words != nullptr ? *words : toml_text(value);
}

std::string edit_page(const std::string& name, const Settings& settings) {
  const std::string html =
      fmt::format("<h1>{}</h1>\n", escape(name)) + bars() +
      "<div class=\"desk\">\n<div class=\"sheet\"><canvas id=\"canvas\" tabindex=\"0\" aria-label=\"The "
      "picture, its mask and "
      "your strokes\"></canvas>\n<p id=\"message\" role=\"alert\" hidden=\"hidden\"></p>\n"
      "<form id=\"asked\" hidden=\"hidden\"><label><span id=\"asked-for\"></span> <input type=\"text\" "
      "id=\"answer\" "
      "autocomplete=\"off\"/></label> <button type=\"submit\">OK</button> <button type=\"button\" "
      "id=\"no-answer\">"
      "Cancel</button></form></div>\n" +
      side(settings) + "</div>\n";
  return output::editing_page(name + " - mesopix", html, colours_json());
}

}  // namespace app
