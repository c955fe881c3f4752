/// Resampling of a picture to the pixels of the mask.
#pragma once

#include "specimen/convert/grains.hpp"

namespace specimen {

/// Size of the mask of a picture.
struct Resampling {
  int source_rows = 0, source_cols = 0;  ///< of the (cropped) picture [px]
  int factor = 1;                        ///< edge of a cell of the raster to resample [px of the picture]
  int rows = 0, cols = 0;                ///< of the mask
  /// Picture pixels per mask pixel [-].
  [[nodiscard]] double ratio() const { return static_cast<double>(source_cols) / cols; }
};

/// Size of a mask of `pixels` columns. The number of rows follows from square pixels and is even: the last
/// row covers at least half of its picture rows, and less than two mask rows are omitted at the bottom.
/// @throws Error if the picture is too flat for two rows.
[[nodiscard]] Resampling choose_mask_size(int source_rows, int source_cols, int factor, int pixels);

/// Cell under the centre of each pixel of the mask.
[[nodiscard]] Raster<Cell> at_centres(const Raster<Cell>& cells, const Resampling& to);

/// Each pixel of the mask gets the phase that covers most of it (the lower label if equal), and for aggregate
/// the grain that covers most of it; of the pixels that are about half aggregate as many are as keep its
/// area. An ITZ, where the picture has one, is drawn anew: the mortar along the edges of the aggregate
/// becomes ITZ, one pixel thick, where there was some. If the mask has more pixels than the picture: the
/// nearest pixel.
[[nodiscard]] Raster<Cell> resampled(const Raster<Cell>& cells, const Resampling& to);

}  // namespace specimen
