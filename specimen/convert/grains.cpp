#include "specimen/convert/grains.hpp"

#include <algorithm>

#include "specimen/body/components.hpp"

namespace specimen {

std::vector<std::int32_t> grain_numbers(const Raster<Cell>& cells) {
  std::vector<std::int32_t> numbers;
  for (const Cell cell : cells.data)
    if (cell >= first_grain && (numbers.empty() || numbers.back() != cell - first_grain))
      numbers.push_back(cell - first_grain);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

int number_grains(Raster<Cell>& cells) {
  const Components pieces = connected_pieces(cells, Connectivity::edges);
  std::vector<std::int32_t> number(pieces.area.size(), 0);
  std::int32_t count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!is_aggregate(cells.data[i])) continue;
    std::int32_t& n = number[static_cast<std::size_t>(pieces.piece.data[i])];
    if (n == 0) n = ++count;
    cells.data[i] = grain(n);
  }
  return count;
}

}  // namespace specimen
