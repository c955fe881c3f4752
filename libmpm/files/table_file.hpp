/// A table as an HDF5 file, one dataset per column.
///
/// Layout:
///   /                attributes: format ("mesopix-table"), format_version
///   /NAME            shape (rows): float64, int64 or UTF-8 text; attributes unit, meaning
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace mpm {

/// A column of a table.
struct TableColumn {
  std::string name;     ///< letters, digits, "_", "." and spaces
  std::string unit;     ///< SI unit; "1" = dimensionless
  std::string meaning;  ///< one line
  std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>> values;

  [[nodiscard]] std::size_t rows() const;  ///< number of values
};

/// Write a table to a temporary name, flush, close and rename it. The same table gives the same bytes.
/// @pre all columns have the same number of rows; names are unique.   @throws FileError.
void write_table(const std::string& path, const std::vector<TableColumn>& columns);

/// Read a table, its columns by name.   @throws FileError naming the file and the fault.
[[nodiscard]] std::vector<TableColumn> read_table(const std::string& path);

}  // namespace mpm
