/// Strokes: pixels of a picture whose phase the user has shown, painted or as lines.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "specimen/convert/convert.hpp"
#include "specimen/picture/picture.hpp"
#include "specimen/teach/taught.hpp"

namespace specimen {

/// What strokes show of each pixel.
struct Strokes {
  Raster<std::uint8_t> labels;                          ///< label of a phase, cut_stroke or no_stroke
  std::vector<std::string> phases = standard_phases();  ///< names of the labels; empty = not in use
  Raster<std::uint8_t> joins{};   ///< 1 where a stroke makes one aggregate of several; empty = nowhere
  std::int64_t painted_over = 0;  ///< pixels of which a later line says something else than an earlier one
};

/// Colour of a stroke that parts two aggregates: black.
inline constexpr Rgb cut_colour{0, 0, 0};

/// Colour of a stroke that makes one aggregate of those that it crosses: magenta.
inline constexpr Rgb one_grain_colour{255, 0, 255};

/// Strokes that were painted over a picture, on a layer that is transparent elsewhere. A pixel that is more
/// than half opaque shows the phase whose phase_colour() it has, within 8 of 255 in each channel; a few
/// pixels of other colours, such as brushes leave at their edges, show nothing.
/// @param drawn  as read from `path`.   @param names  of labels above 3, whose colours may be used too.
/// @throws Error if the picture is opaque or empty, or if more than 2 % of what is painted has other colours.
[[nodiscard]] Strokes painted_strokes(const Picture& drawn, const std::string& path,
                                      const std::vector<std::pair<std::int64_t, std::string>>& names);

/// Strokes along lines. Where two lines cross, the later one holds, as if it were painted over the earlier
/// one; lines of one_grain_word lie beside all others.
/// @param rows, cols  of the picture.
/// @throws Error for a line outside of the picture, and for one that is too thin or too wide.
[[nodiscard]] Strokes strokes_along(const std::vector<StrokeLine>& lines, int rows, int cols);

}  // namespace specimen
