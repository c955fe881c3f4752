#include "apps/text/text_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace app {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> items_between(const std::string& text, char separator) {
  std::vector<std::string> items;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(separator, from), text.size());
    items.emplace_back(trimmed(std::string_view(text).substr(from, to - from)));
    from = to + 1;
  }
  return items;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::vector<CsvCell> csv_cells(const std::string& line) {
  std::vector<CsvCell> cells;
  std::size_t from = 0;
  while (from <= line.size()) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    const std::size_t first = std::min(line.find_first_not_of(" \t", from), comma);
    std::size_t last = comma;
    while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t')) --last;
    cells.push_back({line.substr(first, last - first), static_cast<int>(first) + 1});
    from = comma + 1;
  }
  return cells;
}

void TableReader::read_lines(const std::string& text) {
  std::istringstream stream(text);
  for (std::string line; complaints_.size() < most_complaints && std::getline(stream, line);) {
    ++line_;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // byte order mark
    const bool in_header = !has_header();
    read_line(line);
    if (in_header && !complaints_.empty()) return;  // nothing below can be understood
  }
}

void TableReader::read_line(const std::string& line) {
  const std::string_view content = trimmed(line);
  if (content.empty() || content.front() == '#') return;
  const std::vector<CsvCell> cells = csv_cells(line);
  if (!has_header()) {
    width_ = cells.size();
    read_header(cells);
  } else if (cells.size() == width_) {
    read_row(cells);
  } else {
    complain(1, "row", fmt::format("{} cells", cells.size()), fmt::format("the header has {}", width_));
  }
}

void TableReader::complain(int column, std::string field, std::string value, std::string allowed,
                           std::string cure) {
  const Place place{path_, column == 0 ? 0 : line_, column};
  complaints_.push_back({place, std::move(field), std::move(value), std::move(allowed), std::move(cure)});
}

std::optional<double> TableReader::number_in(const CsvCell& cell, const std::string& name,
                                             const std::string& unit, Dimension dimension) {
  try {
    return parse_quantity(cell.text + " " + unit, dimension);
  } catch (const Mistake&) {
    complain(cell.column, name, quoted(cell.text), "must be a number, its unit is in the header");
    return std::nullopt;
  }
}

std::pair<std::string, std::string> TableReader::name_and_unit(const CsvCell& heading) {
  const std::string& text = heading.text;
  // "stress (MPa)", "stress [MPa]" and "stress / MPa", as people and testing machines write them
  for (const char* pair : {"()", "[]", "/"}) {
    const std::size_t open = text.find(pair[0]);
    if (open == std::string::npos || open == 0 || text.find('_') < open) continue;
    if (pair[1] != '\0' && text.back() != pair[1]) continue;
    const std::size_t length = text.size() - open - (pair[1] == '\0' ? 1 : 2);
    return {std::string(trimmed(text.substr(0, open))), std::string(trimmed(text.substr(open + 1, length)))};
  }
  const std::size_t bar = text.find('_');
  return {text.substr(0, bar), bar == std::string::npos ? "" : text.substr(bar + 1)};
}

std::string quoted_cell(const std::string& text) {
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

std::string shell_word(const std::string& text) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace app
