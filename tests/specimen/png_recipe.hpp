/// PNG files of every kind, written by libpng itself.
#pragma once

#include <png.h>

#include <cstdint>
#include <vector>

namespace specimen_test {

/// What to put in a PNG; libpng itself writes it.
struct PngRecipe {
  int cols = 0, rows = 0, bits = 8, colour_type = PNG_COLOR_TYPE_GRAY;
  bool interlaced = false;
  std::vector<std::uint8_t> data{};  ///< rows as libpng wants them
  std::vector<png_color> palette{};
  std::vector<std::uint8_t> opacity{};  ///< of the palette
};

inline std::vector<std::uint8_t> make_png(const PngRecipe& recipe) {
  std::vector<std::uint8_t> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, std::size_t n) {
        auto* out = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(p));
        out->insert(out->end(), data, data + n);
      },
      nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(recipe.cols), static_cast<png_uint_32>(recipe.rows),
               recipe.bits, recipe.colour_type, recipe.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!recipe.palette.empty())
    png_set_PLTE(png, info, recipe.palette.data(), static_cast<int>(recipe.palette.size()));
  if (!recipe.opacity.empty())
    png_set_tRNS(png, info, recipe.opacity.data(), static_cast<int>(recipe.opacity.size()), nullptr);
  png_write_info(png, info);
  const std::size_t stride = png_get_rowbytes(png, info);
  std::vector<png_bytep> rows;
  std::vector<std::uint8_t> data = recipe.data;
  for (int r = 0; r < recipe.rows; ++r) rows.push_back(data.data() + static_cast<std::size_t>(r) * stride);
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

}  // namespace specimen_test
