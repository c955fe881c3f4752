#include "apps/scene/ellipse_list.hpp"

#include <fmt/format.h>

#include <optional>
#include <sstream>

#include "apps/system/files.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

constexpr const char* header_form = "write a header such as x_mm,y_mm,a_mm,b_mm,angle_deg";

/// A column of the file: what it holds and in which unit.
struct Column {
  EllipseColumn meaning;
  std::string unit;
};

class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  std::vector<specimen::Ellipse> read(const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; complaints_.size() < most_complaints && std::getline(stream, line);) {
      ++line_;
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line_ == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0) line.erase(0, 3);  // byte order mark
      const std::size_t first = line.find_first_not_of(" \t");
      if (first == std::string::npos || line[first] == '#') continue;
      if (columns_.empty()) {
        read_header(line);
        if (!complaints_.empty()) break;  // nothing below can be understood
      } else {
        read_row(line);
      }
    }
    if (columns_.empty() && complaints_.empty()) complain(0, path_, "no header", header_form);
    if (complaints_.empty() && ellipses_.empty()) complain(0, path_, "no ellipses", "give one a line");
    if (!complaints_.empty()) throw Rejected(Exit::data, complaints_);
    return ellipses_;
  }

 private:
  void complain(int column, std::string field, std::string value, std::string allowed,
                std::string cure = {}) {
    const bool whole_file = column == 0;
    complaints_.push_back({whole_file ? Place{} : Place{path_, line_, column}, std::move(field),
                           std::move(value), std::move(allowed), std::move(cure)});
  }

  void read_header(const std::string& line) {
    for (const CsvCell& cell : csv_cells(line))
      if (const auto column = column_of(cell)) columns_.push_back(*column);
    for (const EllipseColumn& wanted : ellipse_columns)
      if (wanted.required && !has(wanted.name) && complaints_.empty())
        complain(1, wanted.name, "column missing", header_form);
  }

  bool has(const std::string& name) const {
    for (const Column& column : columns_)
      if (column.meaning.name == name) return true;
    return false;
  }

  std::optional<Column> column_of(const CsvCell& cell) {
    const std::size_t bar = cell.text.find('_');
    const std::string name = cell.text.substr(0, bar);
    const std::string unit = bar == std::string::npos ? "" : cell.text.substr(bar + 1);
    for (const EllipseColumn& column : ellipse_columns) {
      if (column.name != name) continue;
      if (has(name)) complain(cell.column, name, "column given twice", "", "remove one");
      if (is_unit(unit, column.dimension)) return Column{column, unit};
      complain(cell.column, cell.text, "needs the unit of " + app::name(column.dimension), header_form);
      return std::nullopt;
    }
    complain(cell.column, cell.text, "unknown column", header_form);
    return std::nullopt;
  }

  void read_row(const std::string& line) {
    const std::vector<CsvCell> cells = csv_cells(line);
    if (cells.size() != columns_.size()) {
      complain(1, "row", fmt::format("{} cells", cells.size()),
               fmt::format("the header has {}", columns_.size()));
      return;
    }
    specimen::Ellipse ellipse;
    const std::size_t before = complaints_.size();
    for (std::size_t i = 0; i < cells.size(); ++i) read_cell(cells[i], columns_[i], ellipse);
    if (complaints_.size() > before) return;
    try {
      check_axes(ellipse);
      ellipses_.push_back(ellipse);
    } catch (const Mistake& mistake) {
      complain(1, fmt::format("ellipse {}", ellipses_.size() + 1), "", mistake.allowed, mistake.cure);
    }
  }

  void read_cell(const CsvCell& cell, const Column& column, specimen::Ellipse& ellipse) {
    try {
      ellipse.*column.meaning.member =
          parse_quantity(cell.text + " " + column.unit, column.meaning.dimension);
    } catch (const Mistake&) {
      complain(cell.column, column.meaning.name, quoted(cell.text),
               "must be a number, its unit is in the header");
    }
  }

  std::string path_;
  int line_ = 0;
  std::vector<Column> columns_;
  std::vector<specimen::Ellipse> ellipses_;
  std::vector<Complaint> complaints_;
};

}  // namespace

void check_axes(const specimen::Ellipse& ellipse) {
  const auto shown = [](double length) { return format_quantity(length, Dimension::length); };
  if (!(ellipse.b > 0))
    throw Mistake(fmt::format("its short semi-axis b = {} must be > 0", shown(ellipse.b)));
  if (!(ellipse.a >= ellipse.b))
    throw Mistake(
        fmt::format("its semi-axes a = {} and b = {} must obey a >= b", shown(ellipse.a), shown(ellipse.b)),
        "swap them and add 90 deg to the angle");
}

std::vector<specimen::Ellipse> parse_ellipse_list(const std::string& text, const std::string& path) {
  return Reader(path).read(text);
}

std::vector<specimen::Ellipse> read_ellipse_list(const std::string& path) {
  return parse_ellipse_list(read_text_file(path, longest_table), path);
}

}  // namespace app
