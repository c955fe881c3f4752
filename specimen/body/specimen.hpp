/// A specimen: mask, aggregates, ITZ rings and provenance; and its validation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/body/ring.hpp"

namespace specimen {

/// The origin of a specimen, so that it can be made again.
struct Provenance {
  std::string source;      ///< "generated", "ellipse list", or the file name of the picture
  std::string sha256;      ///< of the source file, lower-case hexadecimal; empty when generated
  std::string options;     ///< the resolved options, as TOML text
  std::uint64_t seed = 0;  ///< seed of the random ellipses; 0 = none were drawn
  std::string version;     ///< version of mesopix
  std::vector<std::string> warnings = {};  ///< guesses on the way that may well be wrong, one sentence each
  friend bool operator==(const Provenance&, const Provenance&) = default;
};

/// A specimen, ready to be simulated.
struct Specimen {
  LabelledMask mask;
  std::vector<Inclusion> inclusions;
  ItzOptions itz;
  std::vector<Ring> rings;  ///< one per inclusion, none for ItzMode::none; for ItzMode::points their
                            ///< vertices are the extra material points
  Provenance provenance;
};

/// Mask and instances before the ITZ is drawn, from ellipses or from a picture.
struct Segmented {
  LabelledMask mask;               ///< void, aggregate, mortar and the user's own phases
  Raster<std::int32_t> instances;  ///< 0 = no aggregate, otherwise the id of the inclusion; shape of the mask
  std::vector<Inclusion> inclusions;  ///< ids are 1 ... n in this order
};

/// Add a ring around every inclusion and draw the rings into the mask, as the options say.
/// @throws Error for a negative thickness or fewer than 3 segments.
[[nodiscard]] Specimen make_specimen(Segmented segmented, const ItzOptions& itz, Provenance provenance);

/// Draw ellipses: aggregate where the centre of a pixel is inside an ellipse, mortar elsewhere.
/// @param width, height  of the specimen [m].   @param pixel_size  [m].
/// @throws Error if two ellipses overlap or one crosses the border, with their numbers; for a size that is
/// not a whole number of pixels.
[[nodiscard]] Segmented draw_ellipses(const std::vector<Ellipse>& ellipses, double width, double height,
                                      double pixel_size);

/// The same in a window whose border may cut ellipses. Ellipses outside, or without a pixel centre, are
/// omitted; ids follow the order of the others. A cut inclusion has a contour.
/// @param width, height  of the window [m].   @param pixel_size  [m].
/// @pre the ellipses do not overlap.   @throws Error for a size that is not a whole number of pixels.
[[nodiscard]] Segmented draw_window(const std::vector<Ellipse>& ellipses, double width, double height,
                                    double pixel_size);

/// Limits of a specimen, independent of the memory. A file that exceeds them is refused by its header, before
/// memory is allocated.
inline constexpr std::int64_t max_pixels = 200'000'000;
inline constexpr std::int64_t max_inclusions = 4'000'000;
inline constexpr std::int64_t max_points = 100'000'000;  ///< vertices of all contours, and of all rings

/// Check a specimen: extents, scale, phase names, labels, inclusions with unique ids and finite values, rings
/// with valid inclusions.
/// @throws Error naming the first fault, e.g. "rings[2].inclusion".
void validate(const Specimen& specimen);

}  // namespace specimen
