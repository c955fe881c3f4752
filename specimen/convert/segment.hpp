/// From the pixels of a picture to phases and grains, before any cleaning.
#pragma once

#include <string>
#include <vector>

#include "specimen/convert/convert.hpp"
#include "specimen/convert/grains.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// A picture whose every pixel has a phase.
struct Sorted {
  Raster<Cell> cells;
  std::vector<std::string> phases = standard_phases();  ///< names of the labels
  int factor = 1;             ///< edge of a cell [px of the picture]: photographs are averaged first
  bool photograph = false;    ///< noisy, so that automatic cleaning has work to do
  bool drawing = false;       ///< of flat colours
  bool keeps_grains = false;  ///< the grains are those of an instance map
};

/// Sort the pixels by the method of the options; the report receives the method, the thresholds and notes.
/// @throws Error when the method does not fit the picture.
[[nodiscard]] Sorted segment(const Picture& picture, const ConvertOptions& options, ConvertReport& report);

}  // namespace specimen
