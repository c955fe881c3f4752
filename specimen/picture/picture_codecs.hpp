/// The two facts of a camera's EXIF block that matter here: which side is up, and the resolution.
/// Pictures whose pixels are indices into a table of colours.
/// One reader and one writer per picture format; picture.cpp chooses among them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_file.hpp"

namespace specimen {

struct ExifTags {
  int orientation = 1;    ///< 1 to 8, see upright()
  double pixel_size = 0;  ///< [m]; 0 = not said
};

/// Read the first directory of an EXIF block ("Exif\0\0", then a small TIFF). Whatever is missing or damaged
/// in it keeps its default: the picture itself does not depend on it.
[[nodiscard]] ExifTags read_exif(std::span<const std::uint8_t> block);

/// Fill a picture from indices and their palette: the indices are kept, and beside them stand the colours, or
/// grey values where the palette holds nothing but greys.
/// @throws Error naming the first pixel whose index is not in the palette.
void set_palette_pixels(Picture& picture, const PictureSource& source, Raster<std::uint8_t> indices,
                        const std::vector<Rgb>& palette);

/// Readers: the file stands at its start. They check the size before they decode.
/// @throws Error naming the file and what is wrong.
[[nodiscard]] Picture read_png(const PictureSource& source);
[[nodiscard]] Picture read_jpeg(const PictureSource& source);
[[nodiscard]] Picture read_tiff(const PictureSource& source);
[[nodiscard]] Picture read_bmp(const PictureSource& source);
[[nodiscard]] Picture read_pnm(const PictureSource& source);

/// Writers into memory; pixel_size [m] goes into the resolution tag where > 0.
/// @param path  for the text of an error only.
[[nodiscard]] Bytes encode_png(const std::string& path, const Raster<Rgb>& picture, double pixel_size);
[[nodiscard]] Bytes encode_png(const std::string& path, const Raster<std::uint8_t>& labels,
                               double pixel_size);
[[nodiscard]] Bytes encode_tiff(const std::string& path, const Raster<std::uint8_t>& labels,
                                double pixel_size);
/// With the scale where ImageJ looks for it.
[[nodiscard]] Bytes encode_imagej_tiff(const std::string& path, const Raster<std::uint8_t>& values,
                                       double pixel_size);
[[nodiscard]] Bytes encode_imagej_tiff(const std::string& path, const Raster<float>& values,
                                       double pixel_size);
[[nodiscard]] Bytes encode_bmp(const Raster<std::uint8_t>& labels, double pixel_size);
[[nodiscard]] Bytes encode_pgm(const Raster<std::uint8_t>& labels);

}  // namespace specimen
