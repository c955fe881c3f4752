/// From a picture to phases and instances: segmentation, cleaning, crop, resampling.
///
/// What automatic does, and what is guessed where nothing is given; all of it is told in the notes.
/// - Method: a picture of whole numbers with 0 and at least five others that lie in one piece each
///   is a map of instances; one of at most eight values (32 where neighbours mostly agree) is a map
///   of labels. Others are photographs, grey or coloured: kmeans. Options that belong to one method
///   call for it.
/// - Values of a map: palette indices where there is a palette, else grey values, else colours as
///   0xRRGGBB. Values out of 0, 1, 2, 3 with 2 among them are our own labels. Of other maps the
///   value with the largest connected piece is mortar (a matrix hangs together, aggregates do not);
///   of three values or more, 0 and 255 are void; the rest is aggregate. Touching aggregates of
///   different values are different inclusions.
/// - Photographs with `pixels` are averaged to twice the columns of the mask (at least 600) before
///   all else.
/// - kmeans with classes = 0: a drawing of flat colours, noisy or not, gets one class a colour; in
///   a cut whose mortar an indicator has dyed pink, tint tells mortar, aggregate and the shaded
///   walls of voids apart; else there are two classes by tint, lightness and roughness. What is
///   darker than half of the median is void. kmeans with a number of classes looks at the colour
///   alone.
/// - Classes: of three or more between thresholds the darkest is void; of the others the one with
///   the largest connected piece is mortar, the rest aggregate.
/// - Cleaning of photographs: median over 1 % of the shorter side; opening (of voids too) and
///   closing by a disc of 0.5 % of it; voids inside aggregates are dark minerals, aggregates inside
///   voids their walls; islands below 1 % of the largest aggregate (a tenth of its diameter) or 0.3
///   % of the picture, whichever is less, and voids below 0.05 % of the picture, join what is round
///   them. Drawings lose specks below 0.02 %.
///
/// Instances are the grains of an instance map, else connected pieces of aggregate, after cutting at the
/// necks where asked for: pixels that share an edge hang together, pixels that touch at a corner do not.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "specimen/body/error.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

enum class Segmentation {
  automatic,   ///< decided from the picture, and told in the report
  labels,      ///< few distinct values, each one a phase
  instances,   ///< 0 = matrix, one value per grain
  threshold,   ///< grey levels given by the user
  otsu,        ///< one threshold
  multi_otsu,  ///< classes - 1 thresholds
  kmeans,      ///< clusters of colour in Lab; grey counts as a colour
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
  /// threshold, otsu, multi_otsu: gray red green blue saturation value (0 to 255), hue (0 to 360), l (0 to
  /// 100), a b (-128 to 127). A grey picture has gray alone, in its own levels.
  std::string channel = "gray";
  /// Rising levels of the channel; a value that reaches a threshold is in the class above. threshold only.
  std::vector<double> thresholds;
  int classes = 0;  ///< multi_otsu, kmeans: 2 to 16; 0 = automatic (3, or as many as there are flat colours)
  /// Phases of the classes, from the darkest to the brightest (kmeans: by lightness L); empty = guessed and
  /// told.
  std::vector<std::string> class_phases;
  /// labels: value -> phase name, for every value of the picture; empty = all guessed and told.
  std::vector<std::pair<std::int64_t, std::string>> label_phases;

  std::int64_t max_pixels = 200'000'000;  ///< of the file; a larger picture is refused before it is decoded
  double source_pixel_size = 0;           ///< [m]; 0 = from the file's resolution tag
  double width = 0;  ///< of the (cropped) picture [m]; the other way to give the scale; 0 = not given
  Crop crop;
  /// Columns of the mask; 0 = as the picture. The rows follow and are an even number: the last one has at
  /// least half of its picture rows, and less than two are left out at the bottom.
  int pixels = 0;

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

/// Neither the options nor the file of a picture tell how large a pixel is.
struct NoScale : Error {
  using Error::Error;
};

/// Convert a picture.
/// @throws NoScale, and Error for options that do not fit it.
[[nodiscard]] Converted convert_picture(Picture picture, const ConvertOptions& options);

/// Convert a picture file.
/// @throws Error as above, and for a file that is no allowed picture.
[[nodiscard]] Converted convert_picture(const std::string& path, const ConvertOptions& options);

/// Intersection over union per phase of two masks of one shape; NaN for a phase in neither.
/// @throws Error when the shapes differ.
[[nodiscard]] std::vector<double> intersection_over_union(const LabelledMask& mask,
                                                          const LabelledMask& reference);

}  // namespace specimen
