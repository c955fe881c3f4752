/// Pictures: reading (PNG, TIFF, BMP, JPEG, PGM/PPM), writing, and the mask in colours.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "specimen/body/mask.hpp"
#include "specimen/body/raster.hpp"
#include "specimen/picture/grey_levels.hpp"

namespace specimen {

/// An RGB pixel, 8 bits a channel.
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// What a file of this program says that it is.
enum class Origin {
  unknown,  ///< another program's, or one without room for such a word
  labels,   ///< a label map: each value is the number of a phase
  preview,  ///< a mask in the colours of its phases
  drawing,  ///< drawn to be looked at: damage, stress
};

/// A picture as read from a file: one channel of grey values or labels, or colour.
/// Grey values are as stored. A picture with a palette has both its colours and the indices into the palette.
struct Picture {
  GreyLevels gray;     ///< values as stored (1 to 64 bit integer, float, perhaps NaN); empty for colour
  Raster<Rgb> colour;  ///< empty for grey; where it is transparent, as stored
  Raster<std::uint8_t> indices;  ///< into the palette; empty if there is none
  Raster<std::uint8_t> opacity;  ///< 0 = transparent, 255 = opaque; empty if all is opaque
  int bits = 8;                  ///< bits per channel, as stored
  double pixel_size = 0;         ///< width of a pixel from the resolution tag [m]; 0 = no tag
  double pixel_aspect = 1;       ///< height of a pixel over its width, as the file says [-]
  bool lossy = false;            ///< JPEG: values are not those that were saved
  Origin origin = Origin::unknown;
  std::vector<std::string> phases{};  ///< of the labels, where the origin is known
  /// What the values that a palette shows are called: their indices, where no two of these show the same.
  std::map<std::int64_t, std::int64_t> names{};
  std::vector<std::string> notes{};  ///< what was left out of the file, one sentence each
  [[nodiscard]] int rows() const { return gray.empty() ? colour.rows : gray.rows; }
  [[nodiscard]] int cols() const { return gray.empty() ? colour.cols : gray.cols; }
};

/// Told the rows and columns of a picture before its pixels are decoded, which may take long.
using SizeListener = std::function<void(std::int64_t rows, std::int64_t cols)>;

/// Read a picture. Its first bytes decide the format, not its name. The size in the header is checked before
/// anything is decoded.
/// @param max_pixels  larger pictures are refused.   @throws Error naming the file and the fault.
[[nodiscard]] Picture read_picture(const std::string& path, std::int64_t max_pixels = 200'000'000,
                                   SizeListener before_pixels = {});

/// Write RGB as PNG, to a temporary name that is then renamed.
/// @param pixel_size  [m], written as pHYs tag; 0 = no tag.   @param origin  drawing: the file says that it
/// is one.   @throws Error (Fault::write).
void write_png(const std::string& path, const Raster<Rgb>& picture, double pixel_size = 0,
               Origin origin = Origin::unknown);

/// Write preview() of a mask as PNG, which says so.   @throws Error (Fault::write).
void write_preview(const std::string& path, const LabelledMask& mask);

/// A photograph, and beside it the same under a mask: in the colours of the phases, half transparent, with
/// lines where phases meet.   @param photograph  of whole pixels a pixel of the mask.
/// @param uncertain  1 where the phase is in doubt, hatched in yellow; shape of the photograph, or empty.
[[nodiscard]] Raster<Rgb> overlay(const Raster<Rgb>& photograph, const LabelledMask& mask,
                                  const Raster<std::uint8_t>& uncertain = {});

/// Write overlay() as PNG, which says that it is a drawing.   @throws Error (Fault::write).
void write_overlay(const std::string& path, const Raster<Rgb>& photograph, const LabelledMask& mask,
                   const Raster<std::uint8_t>& uncertain = {});

/// Write 8-bit labels in the format of the file extension: .png, .tif, .tiff (with the scale in the
/// resolution tags), .bmp, .pgm. They say that they are labels; reading them gives the same ones.   @throws
/// Error for another extension, or if the disk fails.
void write_labels(const std::string& path, const LabelledMask& mask);

/// Write one channel as a TIFF that ImageJ and Fiji open with its scale in mm. They read the unit from the
/// description, because the resolution tags allow only cm and inch. Bytes are displayed from black = 0 to
/// white = the largest value. Not-a-number is kept.
/// @param pixel_size  [m].   @throws Error (Fault::write).
void write_imagej_tiff(const std::string& path, const Raster<std::uint8_t>& values, double pixel_size);
void write_imagej_tiff(const std::string& path, const Raster<float>& values, double pixel_size);
/// The labels of a mask, which the file says they are.
void write_imagej_tiff(const std::string& path, const LabelledMask& mask);

/// Colour of each phase: void white, aggregate blue-grey, mortar sand, ITZ dark orange, others from a
/// colour-blind-safe list.
[[nodiscard]] Rgb phase_colour(std::uint8_t label);

/// The mask in these colours, one pixel per pixel of the mask.
[[nodiscard]] Raster<Rgb> preview(const LabelledMask& mask);

}  // namespace specimen
