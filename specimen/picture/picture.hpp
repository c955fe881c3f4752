/// Pictures on disk: PNG, TIFF, BMP, JPEG, PGM/PPM in; PNG and TIFF out.
/// Pictures for the eye: the mask in colours.
#pragma once

#include <cstdint>
#include <string>

#include "specimen/body/mask.hpp"
#include "specimen/body/raster.hpp"

namespace specimen {

/// An RGB pixel, 8 bits a channel.
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// A picture as read: one grey or label channel, or colour.
/// Grey values are as stored, an alpha channel beside them is passed over; of colour, transparency is laid
/// over white. A picture with a palette holds both its colours and the indices into the palette.
struct Picture {
  Raster<double> gray;           ///< the values as stored (1 to 32 bit integer, float); empty for colour
  Raster<Rgb> colour;            ///< empty for grey
  Raster<std::uint8_t> indices;  ///< into the palette; empty where the file has none
  int bits = 8;                  ///< per channel, as stored
  double pixel_size = 0;         ///< from the resolution tag [m]; 0 = the file does not say
  [[nodiscard]] int rows() const { return gray.empty() ? colour.rows : gray.rows; }
  [[nodiscard]] int cols() const { return gray.empty() ? colour.cols : gray.cols; }
};

/// Read a picture; the format is taken from its first bytes, not from its name.
/// The size is read from the header and checked before anything is decoded.
/// @param max_pixels  refuse larger pictures.   @throws Error naming the file and what is wrong.
[[nodiscard]] Picture read_picture(const std::string& path, std::int64_t max_pixels = 200'000'000);

/// Write RGB as PNG, with the pixel size [m] as its pHYs tag where > 0.
/// Written to a temporary name, then renamed.   @throws Error (Fault::write).
void write_png(const std::string& path, const Raster<Rgb>& picture, double pixel_size = 0);

/// Write 8-bit labels by the ending of the name: .png, .tif, .tiff (with the scale in the resolution tags),
/// .bmp, .pgm. Reading them back gives the same labels.   @throws Error for another ending or when the disk
/// fails.
void write_labels(const std::string& path, const LabelledMask& mask);

/// Write values of one channel as a TIFF that ImageJ and Fiji open with its scale in mm: they take the unit
/// from the description, where ImageJ itself keeps it, since the tag of the resolution knows only cm and
/// inch. Bytes show in shades from black = 0 to white = the largest value. Not-a-number stays what it is.
/// @param pixel_size  [m].   @throws Error (Fault::write).
void write_imagej_tiff(const std::string& path, const Raster<std::uint8_t>& values, double pixel_size);
void write_imagej_tiff(const std::string& path, const Raster<float>& values, double pixel_size);

/// Colour of each phase: void white, aggregate blue-grey, mortar sand, ITZ dark orange, others from a
/// colour-blind-safe list.
[[nodiscard]] Rgb phase_colour(std::uint8_t label);

/// The mask in these colours, one pixel a pixel.
[[nodiscard]] Raster<Rgb> preview(const LabelledMask& mask);

}  // namespace specimen
