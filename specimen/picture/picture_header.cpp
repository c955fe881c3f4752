#include "specimen/picture/picture_header.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace specimen {
namespace {

bool starts_with(std::span<const std::uint8_t> bytes, std::string_view magic) {
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

template <class T>
Raster<T> upright(const Raster<T>& from, int orientation) {
  if (from.empty()) return {};
  const bool transposed = orientation >= 5;
  const bool mirror_rows = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
  const bool mirror_cols = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
  Raster<T> to(transposed ? from.cols : from.rows, transposed ? from.rows : from.cols);
  for (int r = 0; r < to.rows; ++r)
    for (int c = 0; c < to.cols; ++c) {
      const int row = mirror_rows ? to.rows - 1 - r : r;
      const int col = mirror_cols ? to.cols - 1 - c : c;
      to(r, c) = transposed ? from(col, row) : from(row, col);
    }
  return to;
}

}  // namespace

PictureFormat format_of(std::span<const std::uint8_t> first_bytes) {
  const auto is = [&](std::string_view magic) { return starts_with(first_bytes, magic); };
  if (is("\x89PNG\r\n\x1a\n")) return PictureFormat::png;
  if (is("\xff\xd8\xff")) return PictureFormat::jpeg;
  for (const std::string_view magic : {std::string_view("II*\0", 4), std::string_view("MM\0*", 4),
                                       std::string_view("II+\0", 4), std::string_view("MM\0+", 4)})
    if (is(magic)) return PictureFormat::tiff;
  if (is("\x89HDF\r\n\x1a\n")) return PictureFormat::hdf5;
  if (is("BM")) return PictureFormat::bmp;
  if (first_bytes.size() >= 3 && first_bytes[0] == 'P' && first_bytes[1] >= '1' && first_bytes[1] <= '7' &&
      (first_bytes[2] == '#' || (first_bytes[2] >= '\t' && first_bytes[2] <= '\r') || first_bytes[2] == ' '))
    return PictureFormat::pnm;
  return PictureFormat::unknown;
}

void check_size(const PictureSource& source, std::int64_t rows, std::int64_t cols, std::int64_t least_bytes) {
  const std::string size = std::to_string(cols) + " x " + std::to_string(rows) + " pixels";
  if (rows <= 0 || cols <= 0) throw bad_picture(source.path, "holds " + size);
  if (rows > INT32_MAX || cols > INT32_MAX || rows > source.max_pixels / cols)
    throw Error(source.path, size, "at most " + std::to_string(source.max_pixels) + " pixels are allowed",
                "make the picture smaller, or raise convert.max_pixels");
  if (source.bytes < least_bytes)
    throw bad_picture(source.path,
                      "is truncated: " + std::to_string(source.bytes) + " bytes cannot hold " + size);
  if (const auto tell = std::exchange(source.before_pixels, nullptr)) tell(rows, cols);
}

PixelShape pixel_shape_of(double per_metre_x, double per_metre_y) {
  const bool usable =
      std::isfinite(per_metre_x) && std::isfinite(per_metre_y) && per_metre_x > 0 && per_metre_y > 0;
  if (!usable) return {};
  const double aspect = per_metre_x / per_metre_y;
  if (aspect > 10 || aspect < 0.1) return {};
  return {1 / per_metre_x, std::abs(aspect - 1) <= 0.01 ? 1 : aspect};
}

Picture upright(Picture picture, int orientation) {
  if (orientation <= 1 || orientation > 8) return picture;
  picture.gray = picture.gray.with([&](const auto& raster) { return upright(raster, orientation); });
  picture.colour = upright(picture.colour, orientation);
  picture.indices = upright(picture.indices, orientation);
  picture.opacity = upright(picture.opacity, orientation);
  if (orientation >= 5) {
    picture.pixel_size *= picture.pixel_aspect;
    picture.pixel_aspect = 1 / picture.pixel_aspect;
  }
  return picture;
}

}  // namespace specimen
