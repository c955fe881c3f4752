/// Segmentation: from the pixels of a picture to phases and grains, before cleaning.
#pragma once

#include <string>
#include <vector>

#include "specimen/convert/convert.hpp"
#include "specimen/convert/grains.hpp"
#include "specimen/convert/strokes.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// A picture with a phase for every pixel.
struct Sorted {
  Raster<Cell> cells;
  std::vector<std::string> phases = standard_phases();  ///< names of the labels
  int factor = 1;             ///< edge of a cell [px of the picture]: photographs are averaged first
  bool photograph = false;    ///< noisy: automatic cleaning applies
  bool drawing = false;       ///< a drawing in flat colours
  bool keeps_grains = false;  ///< the grains are those of an instance map
  Raster<std::uint8_t>
      outside{};           ///< 1 where a photograph shows no specimen, per pixel of it; empty = nowhere
  bool is_taught = false;  ///< by strokes, which need no guesses about small pieces
  Raster<std::uint8_t> uncertain{};  ///< 1 where two phases are nearly as likely, per cell; empty = not known
  Raster<std::uint8_t> cuts{};       ///< 1 where strokes part aggregates, per cell; empty = nowhere
  Raster<std::uint8_t> joins{};      ///< 1 where strokes make one aggregate of several, per cell
  std::string model{};               ///< what strokes taught, as a file holds it
  Raster<Rgb> shown{};  ///< a photograph to be looked at, as large as four million pixels show it
};

/// Segment the picture by the method of the options; the report receives the method, the thresholds and
/// notes.
/// @param strokes  for method taught without a model: in the shape of the picture.
/// @throws Error if the method does not fit the picture.
[[nodiscard]] Sorted segment(Picture picture, const ConvertOptions& options, ConvertReport& report,
                             Strokes strokes = {});

/// Methods that the other options call for; automatic where they leave it open.
[[nodiscard]] Segmentation implied_method(const ConvertOptions& options);

}  // namespace specimen
