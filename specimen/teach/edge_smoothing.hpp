/// Smoothing that keeps to the edges of the picture.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/raster.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {

/// How likely each class is at each pixel.
struct ClassShares {
  int rows = 0, cols = 0, classes = 0;
  std::vector<std::uint8_t> data;  ///< probability in 255ths, shape (rows, cols, classes)

  ClassShares(int n_rows, int n_cols, int n_classes)
      : rows(n_rows),
        cols(n_cols),
        classes(n_classes),
        data(static_cast<std::size_t>(n_rows) * static_cast<std::size_t>(n_cols) *
             static_cast<std::size_t>(n_classes)) {}
  [[nodiscard]] std::uint8_t* at(int row, int col) {
    return data.data() +
           (static_cast<std::size_t>(row) * static_cast<std::size_t>(cols) + static_cast<std::size_t>(col)) *
               static_cast<std::size_t>(classes);
  }
  [[nodiscard]] const std::uint8_t* at(int row, int col) const {
    return const_cast<ClassShares*>(this)->at(row, col);
  }
};

/// The guided filter with the colours of the picture as its guide: in each square window the probability of a
/// class is the linear function of L, a and b that fits it best, so that noise is averaged and a boundary
/// goes where the colour changes. Source: He, Sun, Tang (2013), equations 14 to 16 and the ridge of
/// equation 5.
/// @param radius  the windows have 2 radius + 1 pixels [px]; 0 = no smoothing.
/// @param ridge  contrast below which a change of colour is noise [L].
/// The same bits on any number of threads.
[[nodiscard]] ClassShares smoothed_along_edges(const ClassShares& shares, const Raster<Lab>& picture,
                                               int radius, double ridge, int threads);

}  // namespace specimen
