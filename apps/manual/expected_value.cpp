#include "apps/manual/expected_value.hpp"

#include <algorithm>
#include <regex>

#include "apps/settings/offer.hpp"
#include "apps/settings/schema.hpp"

namespace manual {
namespace {

constexpr const char* phase_placeholder = "--PHASE.";

bool says(const std::string& text, const std::string& word) { return text.find(word) != std::string::npos; }

/// The parts of "smooth|rough", "LENGTH|auto" that are to be written as they stand; other parts name a type.
std::vector<std::string> literal_words(const std::string& type) {
  std::vector<std::string> words;
  if (!says(type, "|")) return words;
  static const std::regex literal("[a-z0-9_]+|[A-Z][0-9]+");  // A16 is a sieve curve
  std::size_t from = 0;
  while (from <= type.size()) {
    const std::size_t bar = std::min(type.find('|', from), type.size());
    const std::string part = type.substr(from, bar - from);
    if (std::regex_match(part, literal)) words.push_back(part);
    from = bar + 1;
  }
  return words;
}

/// The words of a help that is nothing but a list of them: "error, stability or features".
std::vector<std::string> listed_words(const std::string& help) {
  static const std::regex list("[a-z]+(, [a-z]+)* or [a-z]+");
  static const std::regex word("[a-z]+");
  std::vector<std::string> words;
  if (!std::regex_match(help, list)) return words;
  for (std::sregex_iterator found(help.begin(), help.end(), word), end; found != end; ++found)
    if (found->str() != "or") words.push_back(found->str());
  return words;
}

std::vector<std::string> endings_in(const std::string& help) {
  std::vector<std::string> endings;
  const auto add = [&](const char* ending) {
    if (std::find(endings.begin(), endings.end(), ending) == endings.end()) endings.emplace_back(ending);
  };
  for (const char* ending : {"h5", "toml", "csv", "html", "svg", "pdf"})
    if (says(help, std::string(".") + ending)) add(ending);
  if (says(help, "CSV")) add("csv");
  if (says(help, "picture") || says(help, "PNG"))
    for (const char* ending : {"png", "tif", "tiff", "jpg", "jpeg", "bmp", "pgm", "ppm"}) add(ending);
  return endings;
}

}  // namespace

ExpectedValue expected(const Option& option) {
  ExpectedValue value;
  value.words = literal_words(option.type);
  value.keys = option.type == "KEY=VALUE";
  value.folders = option.type == "DIR";
  value.files = option.type == "FILE" || option.type == "LABELS" || says(option.type, ".csv");
  if (value.files) value.endings = endings_in(option.type + " " + option.help);
  if (value.files && says(option.help, "folder")) value.folders = true;
  return value;
}

ExpectedValue expected(const Argument& argument) {
  ExpectedValue value;
  value.words = listed_words(argument.help);
  value.endings = endings_in(argument.help);
  value.files = !value.endings.empty() || says(argument.help, "file");
  value.folders = says(argument.help, "folder");
  value.commands = argument.name == "COMMAND";
  return value;
}

std::vector<std::string> listed_names(const Option& option) {
  std::vector<std::string> names;
  if (option.group.empty()) return names;
  for (const std::string& name : option.names)
    if (!says(name, ".") || &name == &option.names.front()) names.push_back(name);
  return names;
}

std::vector<std::string> names_by_key(const Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    if (says(name, ".")) names.push_back(name);
  return names;
}

bool is_of_phases(const Option& option) { return option.names.front().rfind(phase_placeholder, 0) == 0; }

std::vector<Option> with_phases(const std::vector<Option>& options) {
  std::vector<Option> all;
  for (const Option& option : options) {
    if (!is_of_phases(option)) {
      all.push_back(option);
      continue;
    }
    for (const mpm::Phase& phase : app::Settings().phases) {
      Option one = option;
      one.names = {"--" + phase.name + "." +
                   option.names.front().substr(std::string(phase_placeholder).size())};
      one.help += " of " + phase.name;
      all.push_back(std::move(one));
    }
  }
  return all;
}

std::string option_by_key(const Command& command) { return "--" + app::with_dashes(keys_of(command).back()); }

std::vector<std::string> keys_of(const Command& command) {
  std::vector<std::string> names;
  for (const Option& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  const auto has = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<std::string> keys;
  if (!has("--set")) return keys;
  for (const app::Field& field : app::fields())
    if (has("--" + app::with_dashes(field.key))) keys.push_back(field.key);
  for (const mpm::Phase& phase : app::Settings().phases)
    for (const app::PhaseField& property : app::phase_fields())
      if (has(phase_placeholder + app::with_dashes(property.key)))
        keys.push_back("phases." + phase.name + "." + property.key);
  return keys;
}

}  // namespace manual
