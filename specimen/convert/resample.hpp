/// From the pixels of the picture to those of the mask.
#pragma once

#include "specimen/convert/grains.hpp"

namespace specimen {

/// Size of the mask that a picture becomes.
struct Resampling {
  int source_rows = 0, source_cols = 0;  ///< of the (cropped) picture [px]
  int factor = 1;                        ///< edge of a cell of the raster to resample [px of the picture]
  int rows = 0, cols = 0;                ///< of the mask
  [[nodiscard]] double ratio() const { return static_cast<double>(source_cols) / cols; }  ///< [px a pixel]
};

/// Mask of `pixels` columns; the rows follow with square pixels and are an even number: the last row of
/// pixels has at least half of its picture rows, and less than two mask rows are left out at the bottom.
/// @throws Error when the picture is too flat for two rows.
[[nodiscard]] Resampling choose_mask_size(int source_rows, int source_cols, int factor, int pixels);

/// Each pixel of the mask becomes the phase that covers most of it (the lower label among equals), and where
/// that is aggregate, the grain that covers most of it. With more pixels than the picture has: the nearest.
[[nodiscard]] Raster<Cell> resampled(const Raster<Cell>& cells, const Resampling& to);

}  // namespace specimen
