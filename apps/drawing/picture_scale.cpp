#include "apps/drawing/picture_scale.hpp"

#include <algorithm>
#include <array>

namespace output {
namespace {

using specimen::Raster;
using specimen::Rgb;

Rgb mean_of(const Raster<Rgb>& picture, int top, int left, int side) {
  std::array<int, 3> sum{};
  int count = 0;
  for (int row = top; row < std::min(top + side, picture.rows); ++row)
    for (int col = left; col < std::min(left + side, picture.cols); ++col, ++count) {
      const Rgb& pixel = picture(row, col);
      sum[0] += pixel.r;
      sum[1] += pixel.g;
      sum[2] += pixel.b;
    }
  const auto mean = [count](int total) { return static_cast<std::uint8_t>((total + count / 2) / count); };
  return {mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

}  // namespace

Raster<Rgb> magnified(const Raster<Rgb>& picture, int factor) {
  Raster<Rgb> large(picture.rows * factor, picture.cols * factor);
  for (int row = 0; row < large.rows; ++row)
    for (int col = 0; col < large.cols; ++col) large(row, col) = picture(row / factor, col / factor);
  return large;
}

Raster<Rgb> shrunk(const Raster<Rgb>& picture, int factor) {
  if (factor == 1) return picture;
  Raster<Rgb> small((picture.rows + factor - 1) / factor, (picture.cols + factor - 1) / factor);
  for (int row = 0; row < small.rows; ++row)
    for (int col = 0; col < small.cols; ++col)
      small(row, col) = mean_of(picture, row * factor, col * factor, factor);
  return small;
}

int file_magnification(int rows, int cols) {
  const int wanted = (600 + cols - 1) / cols;
  return std::clamp(4000 / rows, 1, wanted);
}

int shrink_factor(int rows, int cols, int most) { return (std::max(rows, cols) + most - 1) / most; }

}  // namespace output
