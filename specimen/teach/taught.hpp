/// A classifier of pixels that strokes have taught: what it is, and how it is asked.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/raster.hpp"
#include "specimen/teach/edge_smoothing.hpp"
#include "specimen/teach/forest.hpp"
#include "specimen/teach/pixel_features.hpp"

namespace specimen {

inline constexpr std::uint8_t no_stroke = 255;   ///< where nothing was shown
inline constexpr std::uint8_t cut_stroke = 254;  ///< where two aggregates that touch are to be parted

/// All that is needed to sort the pixels of another picture of the same series.
struct TaughtModel {
  std::vector<std::string> phases;  ///< of the classes
  int scales = 2;                   ///< of the features
  int factor = 1;                   ///< edge of a cell [px]: large pictures are averaged first
  double pixel_size = 0;            ///< of the picture that taught it [m]
  bool evens_light = false;         ///< whether the light was evened out before
  Forest forest;
  friend bool operator==(const TaughtModel&, const TaughtModel&) = default;
};

/// What strokes taught, and how well.
struct TeachingReport {
  struct OfPhase {
    std::string phase;
    std::int64_t strokes = 0, cells = 0;
    double right = 0;  ///< share of the cells told rightly by trees that did not see their stroke; or NaN
  };
  std::vector<OfPhase> phases;
};

/// Teach a classifier.
/// @param strokes  a label for each cell, no_stroke where there is none; the shape of the features.
/// @param names  of the labels.
/// @throws Error if fewer than two phases have strokes, or one too small a stroke.
[[nodiscard]] TaughtModel teach(const PixelFeatures& features, const Raster<std::uint8_t>& strokes,
                                const std::vector<std::string>& names, int threads, TeachingReport& report);

/// How likely each phase of the model is in each cell. Cells are sorted in tiles of 128 x 64, so that there
/// is little beyond the result in memory.
[[nodiscard]] ClassShares ask(const TaughtModel& model, const PixelFeatures& features, int threads);

/// The same for a part of the picture.
/// @param[out] shares  takes rows row to row + rows - 1 and columns col to col + cols - 1.
void ask_tile(const TaughtModel& model, const PixelFeatures& features, int row, int col, int rows, int cols,
              ClassShares& shares);

}  // namespace specimen
