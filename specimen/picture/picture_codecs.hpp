/// Readers and writers of picture formats, from which picture.cpp chooses; EXIF orientation and resolution;
/// palettes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "specimen/picture/picture.hpp"
#include "specimen/picture/picture_file.hpp"
#include "specimen/picture/picture_header.hpp"

namespace specimen {

struct ExifTags {
  int orientation = 1;  ///< 1 to 8, see upright()
  PixelShape shape{};
};

/// Read the first directory of an EXIF block: a small TIFF, in JPEG with "Exif\0\0" before it. Missing or
/// damaged entries keep their defaults: the pixels do not depend on them.
[[nodiscard]] ExifTags read_exif(std::span<const std::uint8_t> block);

/// Forget an opacity that is full everywhere.
void drop_if_opaque(Picture& picture);

/// What this program writes into its own pictures: "labels void,aggregate,mortar,itz", "preview ...",
/// "drawing".
inline constexpr const char* own_keyword = "mesopix";
[[nodiscard]] std::string own_words(Origin origin, const std::vector<std::string>& phases);
/// Set origin and phases of a picture by these words; others are passed over.
void set_origin(Picture& picture, std::string_view words);

/// A colour of 16 bits a channel.
struct DeepRgb {
  std::uint16_t r = 0, g = 0, b = 0;
};

/// How colours of 16 bits become bytes: as they are where none is above 255, without their lower byte where
/// that is empty everywhere, otherwise as shares of white.
class DeepToByte {
 public:
  void look_at(std::uint16_t channel);
  [[nodiscard]] std::uint8_t operator()(std::uint16_t channel) const;

 private:
  bool small_ = true, upper_ = true;
};

/// Fill a picture from colours of 16 bits: grey of 16 bits where red, green and blue are alike everywhere, as
/// small numbers of labels would be lost in bytes.
/// @param colour_at  DeepRgb of a pixel, by its number row by row.
template <class ColourAt>
void set_deep_colours(Picture& picture, int rows, int cols, const ColourAt& colour_at) {
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
  bool is_gray = true;
  DeepToByte byte;
  for (std::size_t i = 0; i < count; ++i) {
    const DeepRgb c = colour_at(i);
    is_gray = is_gray && c.r == c.g && c.g == c.b;
    for (const std::uint16_t channel : {c.r, c.g, c.b}) byte.look_at(channel);
  }
  const auto fill = [&](auto raster, const auto& value_of) {
    for (std::size_t i = 0; i < count; ++i) raster.data[i] = value_of(colour_at(i));
    return raster;
  };
  if (is_gray)
    picture.gray = fill(Raster<std::uint16_t>(rows, cols), [](DeepRgb c) { return c.r; });
  else
    picture.colour = fill(Raster<Rgb>(rows, cols), [&](DeepRgb c) {
      return Rgb{byte(c.r), byte(c.g), byte(c.b)};
    });
}

/// Fill a picture from indices and a palette: with the indices, and with the colours, or grey values if the
/// palette has only greys; with the opacity of the indices, where some are given.
/// @throws Error naming the first pixel whose index is not in the palette.
void set_palette_pixels(Picture& picture, const PictureSource& source, Raster<std::uint8_t> indices,
                        const std::vector<Rgb>& palette, const std::vector<std::uint8_t>& opacity = {});

/// Readers, from the start of the file. They check the size before they decode.
/// @throws Error naming the file and the fault.
[[nodiscard]] Picture read_png(const PictureSource& source);
[[nodiscard]] Picture read_jpeg(const PictureSource& source);
[[nodiscard]] Picture read_tiff(const PictureSource& source);
[[nodiscard]] Picture read_bmp(const PictureSource& source);
[[nodiscard]] Picture read_pnm(const PictureSource& source);

/// Writers into memory; pixel_size [m] is written as resolution tag if > 0. Labels are marked as such, where
/// the format has room for it.
/// @param path  only for error messages.   @param words  own_words() of the picture; empty = another's.
[[nodiscard]] Bytes encode_png(const std::string& path, const Raster<Rgb>& picture, double pixel_size,
                               const std::string& words);
[[nodiscard]] Bytes encode_png(const std::string& path, const LabelledMask& mask);
[[nodiscard]] Bytes encode_tiff(const std::string& path, const LabelledMask& mask);
/// With the scale in the form that ImageJ reads.
[[nodiscard]] Bytes encode_imagej_tiff(const std::string& path, const Raster<std::uint8_t>& values,
                                       double pixel_size);
[[nodiscard]] Bytes encode_imagej_tiff(const std::string& path, const Raster<float>& values,
                                       double pixel_size);
[[nodiscard]] Bytes encode_imagej_tiff(const std::string& path, const LabelledMask& mask);
[[nodiscard]] Bytes encode_bmp(const LabelledMask& mask);
[[nodiscard]] Bytes encode_pgm(const LabelledMask& mask);

}  // namespace specimen
