/// From a picture to phases and instances: segmentation, cleaning, crop, resampling.
///
/// What `automatic` does, and what is guessed for options that are not given; the notes report all of it.
/// - Files of this program say what they are: their labels, and the colours of their previews, are read as
/// such.
/// - Method: a map in which one value lies between at least five others, which are in one piece each, is one
/// of
///   instances; a picture of at most eight values (32 if neighbours mostly agree) is a map of labels. Pixels
///   between two flat tones (smooth edges, JPEG) go to the nearer one. Others are photographs, grey or
///   coloured: kmeans. Options that belong to one method select it.
/// - Values of a map: palette indices if there is a palette, otherwise grey values, otherwise colours as
///   0xRRGGBB. Their phases are read from how they lie in the picture, whatever the numbers are
///   (reading.hpp). A map that can be read in two ways is refused. Touching aggregates of different values
///   are different inclusions.
/// - Outside of a round or tilted specimen there is void (Outside).
/// - Pixels that are not square, as the file says, are made square by repeating rows or columns.
/// - Photographs with `pixels` are first averaged to twice the columns of the mask (at least 600);
///   those of more than 16 million pixels over squares of at least 3 x 3.
/// - kmeans with classes = 0: a drawing in flat colours, noisy or not, gets one class per colour. In a cut
///   whose mortar is dyed pink by an indicator, the tint separates mortar, aggregate and the shaded walls of
///   voids. Otherwise there are two classes by tint, lightness and roughness. Pixels darker than half of the
///   median are void. kmeans with a given number of classes uses the colour only.
/// - taught: a random forest on features of each pixel at several scales learns from strokes (forest.hpp,
///   pixel_features.hpp); its probabilities are smoothed along the edges of the picture (edge_smoothing.hpp),
///   and boundaries go where the colours near by part (local_colours.hpp). A picture of more than 8 million
///   pixels is averaged over squares first. The only automatic cleaning is that islands below a square of 1 %
///   of the shorter side join their surroundings.
/// - Classes: of three or more classes between thresholds the darkest is void; of the others the one with the
///   largest connected piece is mortar, the rest is aggregate.
/// - Cleaning of photographs: median over 1 % of the shorter side; opening (of voids too) and closing by a
/// disc
///   of 0.5 % of it. Voids inside aggregates are dark minerals, aggregates inside voids are the walls of the
///   voids. Islands below 1 % of the largest aggregate (a tenth of its diameter) or 0.3 % of the picture,
///   whichever is less, and voids below 0.05 % of the picture, join their surroundings. Drawings lose specks
///   below 0.02 %.
///
/// Instances are the grains of an instance map, otherwise connected pieces of aggregate, after cutting at the
/// necks if asked for. Pixels that share an edge are connected; pixels that share only a corner are not.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "specimen/body/error.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {

/// Segmentation method.
enum class Segmentation {
  automatic,   ///< chosen from the picture, and reported in the notes
  labels,      ///< few distinct values, each one phase
  instances,   ///< 0 = matrix, one value per grain
  threshold,   ///< grey levels given by the user
  otsu,        ///< one threshold
  multi_otsu,  ///< classes - 1 thresholds
  kmeans,      ///< clusters of colour in Lab; grey counts as a colour
  taught,      ///< learnt from strokes that show some pixels of each phase
};

/// A stroke along a line over a picture, which shows the phase of the pixels under it.
struct StrokeLine {
  std::string phase;  ///< its name, cut_word or one_grain_word
  double width = 3;   ///< [px], 1 to 1000
  std::vector<std::pair<double, double>>
      points{};         ///< x from the left and y from the TOP of the picture [px]
  std::string where{};  ///< place in its file, for messages
};

/// In place of a phase: the line parts two aggregates that touch.
inline constexpr const char* cut_word = "cut";

/// In place of a phase: all pieces of aggregate that the line crosses are one aggregate.
inline constexpr const char* one_grain_word = "one-grain";

/// What of a picture is taken to lie outside of the specimen, and becomes void.
enum class Outside {
  automatic,  ///< transparent pixels; even black or white, or one value of a map, round a convex body
  void_,      ///< as above, without looking for a body: what reaches the most corners
  none,       ///< nothing: transparent pixels are laid over white
};

/// Rectangle of source pixels [px], from the top left corner; width 0 = the whole picture.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

/// In the cleaning options -1 means automatic: maps of labels or instances are not cleaned, photographs are
/// cleaned in proportion to the size of the picture. The notes report what was chosen.
struct ConvertOptions {
  Segmentation method = Segmentation::automatic;
  /// threshold, otsu, multi_otsu: gray red green blue saturation value (0 to 255), hue (0 to 360), l (0 to
  /// 100), a b (-128 to 127). A grey picture has gray alone, in its own levels.
  std::string channel = "gray";
  /// Increasing levels of the channel; a value at a threshold is in the class above. Only for threshold.
  std::vector<double> thresholds;
  int classes = 0;  ///< multi_otsu, kmeans: 2 to 16; 0 = automatic (3, or as many as there are flat colours)
  /// Phases of the classes, from the darkest to the brightest (kmeans: by lightness L); empty = guessed. They
  /// leave the classes of colours as they are without names.
  std::vector<std::string> class_phases;
  /// taught: file of the strokes, a picture of the size of the whole picture that is transparent but for
  /// them; they have the colours of phase_colour().
  std::string strokes;
  std::vector<StrokeLine> stroke_lines;  ///< taught: strokes as lines, in place of a file
  std::string model;                     ///< taught: file of what strokes taught before, in place of strokes
  bool even_light = false;  ///< taught: even out light that changes slowly over the picture (even_light.hpp)
  int smooth =
      -1;  ///< taught: radius of the smoothing along edges [px of the source]; 0 = none, -1 = automatic
  /// labels: value -> phase name, for every value of the picture; empty = all guessed. taught: names of the
  /// phases whose colours are those of labels above 3.
  std::vector<std::pair<std::int64_t, std::string>> label_phases;

  std::int64_t max_pixels = 200'000'000;  ///< a larger picture is refused before it is decoded
  double source_pixel_size = 0;           ///< [m]; 0 = from the file's resolution tag
  double width = 0;  ///< of the (cropped) picture [m], instead of source_pixel_size; 0 = not given
  Crop crop;
  Outside outside = Outside::automatic;
  /// Columns of the mask; 0 = as the picture. The number of rows follows and is even: the last row covers at
  /// least half of its picture rows, and less than two rows are omitted at the bottom.
  int pixels = 0;

  int median = -1;  ///< edge of the median filter on the picture [px], odd; 0 = none, -1 = automatic
  int open = -1;    ///< radius of the opening of aggregates [px of the source]; 0 = none, -1 = automatic
  int close = -1;   ///< radius of the closing of aggregates [px of the source]; 0 = none, -1 = automatic
  /// Islands of any phase smaller than this area [m^2] join their surroundings; 0 = none, -1 = automatic.
  double drop_islands = -1;
  bool fill_holes = false;      ///< fill holes in aggregates
  bool split_touching = false;  ///< cut touching aggregates by a watershed on the distance map
  double split_depth =
      0.2;  ///< least depth of a neck that is cut, as share of the inner radius of the grain [-]
};

/// What the conversion did and guessed.
struct ConvertReport {
  std::vector<std::string> notes;     ///< one sentence each, for the user
  std::vector<std::string> warnings;  ///< guesses that may well be wrong
  double uncertain = not_known;       ///< taught: share of the area where two phases are nearly as likely [-]
  Segmentation method = Segmentation::automatic;  ///< the method used, never automatic
  std::vector<double> thresholds;                 ///< the thresholds used, levels of the channel
  double source_pixel_size = 0;                   ///< [m]
};

/// A converted picture.
struct Converted {
  Segmented segmented;
  ConvertReport report;
  /// Of a photograph: what the mask covers of it, each pixel of the mask as so many pixels that the whole is
  /// about 600 wide; else empty. Transparent parts and greys look as they were segmented.
  Raster<Rgb> photograph{};
  Raster<std::uint8_t>
      uncertain{};      ///< taught: 1 where two phases are nearly as likely, shape of the photograph
  std::string model{};  ///< taught by strokes: what a file of the model holds (model_file.hpp)
};

/// Neither the options nor the file of a picture tell how large a pixel is.
struct NoScale : Error {
  using Error::Error;
};

/// A map of labels that can be read in two ways, one nearly as likely as the other.
struct TwoReadings : Error {
  using Error::Error;
  std::vector<std::string>
      label_phases{};  ///< the two, as "0:void,1:aggregate,2:mortar"; the likelier one first
};

/// Convert a picture.
/// @throws NoScale if the scale is missing; Error if options do not fit the picture.
[[nodiscard]] Converted convert_picture(Picture picture, const ConvertOptions& options);

/// Convert a picture file.
/// @param before_pixels  is told the size of the picture before anything that may take long.
/// @throws Error as above, and for a file that is not a valid picture.
[[nodiscard]] Converted convert_picture(const std::string& path, const ConvertOptions& options,
                                        SizeListener before_pixels = {});

/// Intersection over union [-] of each phase of two masks of the same shape; NaN for a phase in neither.
/// @throws Error if the shapes differ.
[[nodiscard]] std::vector<double> intersection_over_union(const LabelledMask& mask,
                                                          const LabelledMask& reference);

}  // namespace specimen
