#include "apps/manual/help_text.hpp"

#include <iomanip>
#include <optional>
#include <sstream>

namespace manual {
namespace {

constexpr const char* blanks = "  ";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

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

void append_text(std::vector<Passage>& passages, const std::string& line) {
  if (passages.empty() || passages.back().text.empty()) passages.emplace_back();
  std::string& text = passages.back().text;
  text += (text.empty() ? "" : " ") + line;
}

void append_verbatim(std::vector<Passage>& passages, const std::string& line) {
  if (passages.empty() || passages.back().verbatim.empty()) passages.emplace_back();
  passages.back().verbatim.push_back(line.substr(2));
}

void append_item(std::vector<Passage>& passages, const Item& item) {
  if (passages.empty() || passages.back().items.empty()) passages.emplace_back();
  passages.back().items.push_back(item);
}

void append_note(std::vector<Passage>& notes, const std::string& line) {
  if (goes_on(notes, line))
    notes.back().items.back().text += " " + without_blanks(line);
  else if (const auto item = item_in(line))
    append_item(notes, *item);
  else if (line.rfind(blanks, 0) == 0)
    append_verbatim(notes, line);
  else
    append_text(notes, line);
}

}  // namespace

HelpText help_text(const std::string& footer) {
  HelpText text;
  bool examples = false;
  for (const std::string& line : lines_of(footer)) {
    examples = examples || line.rfind("Example", 0) == 0;
    if (!examples)
      append_note(text.notes, line);
    else if (line.rfind(blanks, 0) == 0)
      append_verbatim(text.examples, line);
    else
      append_text(text.examples, line);
  }
  return text;
}

std::vector<std::string> example_commands(const std::string& footer) {
  std::vector<std::string> commands;
  for (const std::string& line : lines_of(footer))
    if (line.rfind("  mesopix ", 0) == 0) commands.push_back(line.substr(2));
  return commands;
}

std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  const auto ends = [](const std::string& word) { return word == "|" || word == ">" || word == "#"; };
  for (std::string word; stream >> std::quoted(word) && !ends(word);) words.push_back(word);
  return words;
}

}  // namespace manual
