/// From a picture to phases and instances: segmentation, cleaning, crop, resampling.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "specimen/specimen.hpp"

namespace specimen {

enum class Segmentation {
  automatic,   ///< decided from the picture, and told in the report
  labels,      ///< few distinct values, each one a phase
  instances,   ///< 0 = matrix, one value per grain
  threshold,   ///< grey levels given by the user
  otsu,        ///< one threshold
  multi_otsu,  ///< classes - 1 thresholds
  kmeans,      ///< clusters of colour in Lab
};

/// Rectangle of source pixels; width 0 = the whole picture.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

/// In the cleaning options -1 means automatic: nothing is cleaned on maps of labels or instances, and
/// photographs are cleaned in proportion to the size of the picture. What automatic chose is told in the
/// notes of the report.
struct ConvertOptions {
  Segmentation method = Segmentation::automatic;
  std::string channel =
      "gray";  ///< threshold, otsu, multi_otsu: gray red green blue hue saturation value l a b
  std::vector<double> thresholds;  ///< rising, in the picture's own levels; threshold only
  int classes = 0;  ///< multi_otsu, kmeans: 2 to 16; 0 = automatic (3, or as many as there are flat colours)
  /// Phases of the classes, from the darkest to the brightest (kmeans: by lightness L); empty = guessed and
  /// told.
  std::vector<std::string> class_phases;
  /// labels: value -> phase name; empty = guessed and told.
  std::vector<std::pair<std::int64_t, std::string>> label_phases;

  double source_pixel_size = 0;  ///< [m]; 0 = from the file's resolution tag
  double width = 0;  ///< of the (cropped) picture [m]; the other way to give the scale; 0 = not given
  Crop crop;
  int pixels = 0;  ///< columns of the mask; 0 = as the picture

  int median = -1;  ///< edge of the median filter on the picture [px], odd; 0 = none, -1 = automatic
  int open = -1;    ///< radius of the opening of aggregates [px of the source]; 0 = none, -1 = automatic
  int close = -1;   ///< radius of the closing of aggregates [px of the source]; 0 = none, -1 = automatic
  /// Islands of any phase below this area join their surroundings [m^2]; 0 = none, -1 = automatic.
  double drop_islands = -1;
  bool fill_holes = false;      ///< of aggregates
  bool split_touching = false;  ///< watershed on the distance map
  double split_depth = 0.2;  ///< how deep a neck must be to be cut, as share of the grain's inner radius [-]
};

/// What conversion did, in the user's words, one sentence each; and what it guessed.
struct ConvertReport {
  std::vector<std::string> notes;
  Segmentation method = Segmentation::automatic;  ///< the one used, never automatic
  std::vector<double> thresholds;                 ///< the ones used
  double source_pixel_size = 0;                   ///< [m]
};

struct Converted {
  Segmented segmented;
  ConvertReport report;
};

/// Convert a picture file.
/// @throws Error for a file that is no allowed picture, a scale that is missing, or options that do not fit
/// it.
[[nodiscard]] Converted convert_picture(const std::string& path, const ConvertOptions& options);

/// Intersection over union per phase of two masks of one shape; NaN for a phase in neither.
/// @throws Error when the shapes differ.
[[nodiscard]] std::vector<double> intersection_over_union(const LabelledMask& mask,
                                                          const LabelledMask& reference);

}  // namespace specimen
