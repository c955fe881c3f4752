/// Readers and writers of picture formats, from which picture.cpp chooses; EXIF orientation and resolution;
/// palettes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_file.hpp"

namespace specimen {

struct ExifTags {
  int orientation = 1;    ///< 1 to 8, see upright()
  double pixel_size = 0;  ///< [m]; 0 = unknown
};

/// Read the first directory of an EXIF block ("Exif\0\0", then a small TIFF). Missing or damaged entries
/// keep their defaults: the pixels do not depend on them.
[[nodiscard]] ExifTags read_exif(std::span<const std::uint8_t> block);

/// Fill a picture from indices and a palette: with the indices, and with the colours, or grey values if the
/// palette has only greys.
/// @throws Error naming the first pixel whose index is not in the palette.
void set_palette_pixels(Picture& picture, const PictureSource& source, Raster<std::uint8_t> indices,
                        const std::vector<Rgb>& palette);

/// Readers, from the start of the file. They check the size before they decode.
/// @throws Error naming the file and the fault.
[[nodiscard]] Picture read_png(const PictureSource& source);
[[nodiscard]] Picture read_jpeg(const PictureSource& source);
[[nodiscard]] Picture read_tiff(const PictureSource& source);
[[nodiscard]] Picture read_bmp(const PictureSource& source);
[[nodiscard]] Picture read_pnm(const PictureSource& source);

/// Writers into memory; pixel_size [m] is written as resolution tag if > 0.
/// @param path  only for error messages.
[[nodiscard]] Bytes encode_png(const std::string& path, const Raster<Rgb>& picture, double pixel_size);
[[nodiscard]] Bytes encode_png(const std::string& path, const Raster<std::uint8_t>& labels,
                               double pixel_size);
[[nodiscard]] Bytes encode_tiff(const std::string& path, const Raster<std::uint8_t>& labels,
                                double pixel_size);
/// With the scale in the form that ImageJ reads.
[[nodiscard]] Bytes encode_imagej_tiff(const std::string& path, const Raster<std::uint8_t>& values,
                                       double pixel_size);
[[nodiscard]] Bytes encode_imagej_tiff(const std::string& path, const Raster<float>& values,
                                       double pixel_size);
[[nodiscard]] Bytes encode_bmp(const Raster<std::uint8_t>& labels, double pixel_size);
[[nodiscard]] Bytes encode_pgm(const Raster<std::uint8_t>& labels);

}  // namespace specimen
