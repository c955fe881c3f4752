/// Cutting up what people write.
/// Lines of tables whose cells stand between commas.
/// Commands that a message tells the user to give.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"

namespace app {

/// The text without the blanks and tabs at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The items between separators, each trimmed; a text without one is one item.
[[nodiscard]] std::vector<std::string> items_between(const std::string& text, char separator);

/// The text as a whole number; nullopt unless it is one from its first letter to its last.
[[nodiscard]] std::optional<std::int64_t> whole_number(std::string_view text);

struct CsvCell {
  std::string text;  ///< without the blanks round it
  int column = 1;    ///< where it begins in its line
};

/// The cells of a line; a line without a comma has one.
[[nodiscard]] std::vector<CsvCell> csv_cells(const std::string& line);

/// A reader of a table with commas between the cells, whose first line tells what stands in the columns.
/// Empty lines and lines that begin with # are passed over.
class TableReader {
 public:
  explicit TableReader(std::string path) : path_(std::move(path)) {}
  virtual ~TableReader() = default;

 protected:
  /// As far as a header that cannot be understood, or as there is use in complaints.
  void read_lines(const std::string& text);
  [[nodiscard]] bool has_header() const { return width_ > 0; }

  /// @param column  0 = about the whole table.
  void complain(int column, std::string field, std::string value, std::string allowed, std::string cure = {});

  /// The number in a cell; nullopt, with a complaint, for what is none.
  std::optional<double> number_in(const CsvCell& cell, const std::string& name, const std::string& unit,
                                  Dimension dimension);

  /// "strain" and "%" of "strain_%", "strain (%)", "strain [%]" and "strain / %".
  [[nodiscard]] static std::pair<std::string, std::string> name_and_unit(const CsvCell& heading);

  std::string path_;
  std::vector<Complaint> complaints_;

 private:
  virtual void read_header(const std::vector<CsvCell>& cells) = 0;
  virtual void read_row(const std::vector<CsvCell>& cells) = 0;  ///< as many as in the header
  void read_line(const std::string& line);

  int line_ = 0;
  std::size_t width_ = 0;  ///< cells in the header
};

/// A cell between quotes, which are doubled inside (RFC 4180).
[[nodiscard]] std::string quoted_cell(const std::string& text);

/// An argument as a shell takes it, in quotes where it needs them.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace app
