/// Lines of tables whose cells stand between commas.
#pragma once

#include <string>
#include <vector>

namespace app {

struct CsvCell {
  std::string text;  ///< without the blanks round it
  int column = 1;    ///< where it begins in its line
};

/// The cells of a line; a line without a comma has one.
[[nodiscard]] std::vector<CsvCell> csv_cells(const std::string& line);

}  // namespace app
