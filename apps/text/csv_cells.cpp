#include "apps/text/csv_cells.hpp"

#include <algorithm>

namespace app {

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

}  // namespace app
