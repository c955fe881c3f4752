#include "apps/report/curve_csv.hpp"

#include "apps/text/text.hpp"
#include "libmpm/scene/history_columns.hpp"

namespace output {
namespace {

std::string cell(double value) { return exact(value); }
std::string cell(std::int64_t value) { return std::to_string(value); }

std::string header_of(const mpm::HistoryColumn& column) { return column_title(column.name, column.unit); }

/// One line of the table; text_of gives the cell of a column.
template <class TextOf>
std::string line(TextOf text_of) {
  std::string text;
  for (const mpm::HistoryColumn& column : mpm::history_columns()) {
    if (!text.empty()) text += ',';
    text += text_of(column);
  }
  return text + '\n';
}

}  // namespace

std::string column_title(std::string_view name, std::string_view unit) {
  std::string title(name);
  if (unit == "1") return title;
  title += '_';
  for (const char c : unit) title += c == '/' ? std::string("_per_") : std::string(1, c);
  return title;
}

std::string curve_csv(const std::vector<mpm::HistoryRow>& history) {
  std::string csv = line(header_of);
  for (const mpm::HistoryRow& row : history)
    csv += line([&](const mpm::HistoryColumn& column) {
      return std::visit([&](auto member) { return cell(row.*member); }, column.member);
    });
  return csv;
}

}  // namespace output
