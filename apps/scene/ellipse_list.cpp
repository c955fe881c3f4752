#include "apps/scene/ellipse_list.hpp"

#include <fmt/format.h>

#include <optional>

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

class Reader : public TableReader {
 public:
  using TableReader::TableReader;

  std::vector<specimen::Ellipse> read(const std::string& text) {
    read_lines(text);
    if (!has_header()) complaints_.push_back(complaint(path_, "no header", header_form));
    if (complaints_.empty() && ellipses_.empty())
      complaints_.push_back(complaint(path_, "no ellipses", "give one a line"));
    if (!complaints_.empty()) throw Rejected(Exit::data, complaints_);
    return ellipses_;
  }

 private:
  void read_header(const std::vector<CsvCell>& cells) override {
    for (const CsvCell& cell : cells)
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
    const auto [name, unit] = name_and_unit(cell);
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

  void read_row(const std::vector<CsvCell>& cells) override {
    specimen::Ellipse ellipse;
    const std::size_t before = complaints_.size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto& [column, unit] = columns_[i];
      ellipse.*column.member =
          number_in(cells[i], column.name, unit, column.dimension).value_or(ellipse.*column.member);
    }
    if (complaints_.size() > before) return;
    try {
      check_axes(ellipse);
      ellipses_.push_back(ellipse);
    } catch (const Mistake& mistake) {
      complain(1, fmt::format("ellipse {}", ellipses_.size() + 1), "", mistake.allowed, mistake.cure);
    }
  }

  std::vector<Column> columns_;
  std::vector<specimen::Ellipse> ellipses_;
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
