/// Fields on the pixels of the picture.
#pragma once

#include <Eigen/Core>

namespace mpm {

/// A value per pixel, shape (rows, cols), row-major; row 0 is the TOP of the picture and y points up, as in
/// the mask: the centre of pixel (row, col) lies at x = (col + 1/2) d, y = (rows - row - 1/2) d.
template <class T>
using Lattice = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace mpm
