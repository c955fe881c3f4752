/// JPEG files of every kind, written by libjpeg itself.
#pragma once

#include <cstddef>
#include <cstdio>

// jpeglib.h needs size_t and FILE before it.
#include <jpeglib.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

namespace specimen_test {

/// A picture of one colour per quarter, written by libjpeg itself.
struct JpegRecipe {
  J_COLOR_SPACE space = JCS_RGB;
  std::vector<std::vector<std::uint8_t>> quarters;  ///< top left, top right, bottom left, bottom right
  int edge = 32;
  bool progressive = false;
  int density = 0;  ///< [dots per inch]
  std::vector<std::uint8_t> app1{};
};

inline std::vector<std::uint8_t> make_jpeg(const JpegRecipe& recipe) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &buffer, &size);
  jpeg.image_width = jpeg.image_height = static_cast<JDIMENSION>(recipe.edge);
  jpeg.input_components = static_cast<int>(recipe.quarters.front().size());
  jpeg.in_color_space = recipe.space;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 100, TRUE);
  if (recipe.progressive) jpeg_simple_progression(&jpeg);
  if (recipe.density > 0) {
    jpeg.density_unit = 1;
    jpeg.X_density = jpeg.Y_density = static_cast<UINT16>(recipe.density);
  }
  jpeg_start_compress(&jpeg, TRUE);
  if (!recipe.app1.empty())
    jpeg_write_marker(&jpeg, JPEG_APP0 + 1, recipe.app1.data(), static_cast<unsigned>(recipe.app1.size()));
  for (int r = 0; r < recipe.edge; ++r) {
    std::vector<std::uint8_t> row;
    for (int c = 0; c < recipe.edge; ++c) {
      const auto& colour =
          recipe.quarters[static_cast<std::size_t>(2 * (r >= recipe.edge / 2) + (c >= recipe.edge / 2))];
      row.insert(row.end(), colour.begin(), colour.end());
    }
    JSAMPROW start = row.data();
    jpeg_write_scanlines(&jpeg, &start, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::vector<std::uint8_t> bytes(buffer, buffer + size);
  jpeg_destroy_compress(&jpeg);
  std::free(buffer);
  return bytes;
}

}  // namespace specimen_test
