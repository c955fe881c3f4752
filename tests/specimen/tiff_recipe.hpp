/// TIFF files of every kind, written by libtiff itself.
#pragma once

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace specimen_test {

/// What to put in a TIFF; libtiff itself writes it.
struct TiffRecipe {
  int cols = 2, rows = 2;
  int bits = 8, format = SAMPLEFORMAT_UINT, samples = 1;
  int photometric = PHOTOMETRIC_MINISBLACK, compression = COMPRESSION_NONE, orientation = ORIENTATION_TOPLEFT;
  int tile = 0;  ///< edge [px]; 0 = strips
  bool big_endian = false;
};

template <class T>
void write_tiff(const std::string& path, const TiffRecipe& recipe, std::vector<T> data) {
  TIFF* tiff = TIFFOpen(path.c_str(), recipe.big_endian ? "wb" : "wl");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, recipe.cols);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, recipe.rows);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, recipe.bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, recipe.samples);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, recipe.format);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, recipe.photometric);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, recipe.compression);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, recipe.orientation);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  if (recipe.photometric == PHOTOMETRIC_PALETTE) {
    std::vector<std::uint16_t> ramp(256, 0);
    for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<std::uint16_t>(257 * (255 - i));
    std::vector<std::uint16_t> none(256, 0);
    TIFFSetField(tiff, TIFFTAG_COLORMAP, ramp.data(), none.data(), none.data());
  }
  if (recipe.tile > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, recipe.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, recipe.tile);
    for (int top = 0; top < recipe.rows; top += recipe.tile)
      for (int left = 0; left < recipe.cols; left += recipe.tile) {
        std::vector<T> tile(static_cast<std::size_t>(recipe.tile) * static_cast<std::size_t>(recipe.tile),
                            T{});
        for (int r = top; r < std::min(recipe.rows, top + recipe.tile); ++r)
          for (int c = left; c < std::min(recipe.cols, left + recipe.tile); ++c)
            tile[static_cast<std::size_t>((r - top) * recipe.tile + c - left)] =
                data[static_cast<std::size_t>(r * recipe.cols + c)];
        TIFFWriteTile(tiff, tile.data(), static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top), 0,
                      0);
      }
  } else {
    const std::size_t stride = data.size() / static_cast<std::size_t>(recipe.rows);
    for (int r = 0; r < recipe.rows; ++r)
      TIFFWriteScanline(tiff, data.data() + static_cast<std::size_t>(r) * stride,
                        static_cast<std::uint32_t>(r), 0);
  }
  TIFFClose(tiff);
}

}  // namespace specimen_test
