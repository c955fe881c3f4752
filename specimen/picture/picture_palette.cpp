#include "specimen/picture/picture_palette.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace specimen {
namespace {

void check_indices(const PictureSource& source, const Raster<std::uint8_t>& indices, std::size_t entries) {
  const auto bad = std::find_if(indices.data.begin(), indices.data.end(),
                                [&](std::uint8_t index) { return index >= entries; });
  if (bad == indices.data.end()) return;
  const std::int64_t at = bad - indices.data.begin();
  throw bad_picture(source.path, "pixel in row " + std::to_string(at / indices.cols) + ", column " +
                                     std::to_string(at % indices.cols) + " has colour " +
                                     std::to_string(*bad) + " of a palette with " + std::to_string(entries) +
                                     " colours");
}

bool all_gray(const std::vector<Rgb>& palette) {
  return std::all_of(palette.begin(), palette.end(), [](Rgb c) { return c.r == c.g && c.g == c.b; });
}

}  // namespace

void set_palette_pixels(Picture& picture, const PictureSource& source, Raster<std::uint8_t> indices,
                        const std::vector<Rgb>& palette) {
  check_indices(source, indices, palette.size());
  if (all_gray(palette)) {
    picture.gray = Raster<double>(indices.rows, indices.cols);
    std::transform(indices.data.begin(), indices.data.end(), picture.gray.data.begin(),
                   [&](std::uint8_t index) { return palette[index].r; });
  } else {
    picture.colour = Raster<Rgb>(indices.rows, indices.cols);
    std::transform(indices.data.begin(), indices.data.end(), picture.colour.data.begin(),
                   [&](std::uint8_t index) { return palette[index]; });
  }
  picture.indices = std::move(indices);
}

}  // namespace specimen
