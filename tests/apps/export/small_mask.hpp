/// A mask that is written down row by row.
#pragma once

#include <string>
#include <vector>

#include "specimen/body/mask.hpp"

namespace test {

/// @param rows  of digits, which are labels, the top row first.   @param pixel_size  [m].
inline specimen::LabelledMask mask_of(const std::vector<std::string>& rows, double pixel_size = 1e-3) {
  specimen::LabelledMask mask;
  mask.pixel_size = pixel_size;
  mask.labels = {static_cast<int>(rows.size()), static_cast<int>(rows.front().size())};
  for (int row = 0; row < mask.labels.rows; ++row)
    for (int col = 0; col < mask.labels.cols; ++col)
      mask.labels(row, col) =
          static_cast<std::uint8_t>(rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(col)] - '0');
  return mask;
}

}  // namespace test
