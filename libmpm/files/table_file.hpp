/// A table as an HDF5 file, one dataset a column.
///
/// Layout, as h5py shows it:
///   /                attributes: format ("mesopix-table"), format_version
///   /NAME            shape (rows): float64, int64 or UTF-8 text; attributes unit, meaning
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace mpm {

struct TableColumn {
  std::string name;     ///< letters, digits, _, . and blanks
  std::string unit;     ///< SI; "1" = without
  std::string meaning;  ///< one line
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;

  [[nodiscard]] std::size_t rows() const;
};

/// Write a table: to a temporary name, flushed, closed and renamed. The same table gives the same bytes.
/// @pre all columns have the same number of rows; names differ.   @throws FileError.
void write_table(const std::string& path, const std::vector<TableColumn>& columns);

}  // namespace mpm
