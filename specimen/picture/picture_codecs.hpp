/// One reader and one writer per picture format; picture.cpp chooses among them.
#pragma once

#include <cstdint>

#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_file.hpp"

namespace specimen {

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
