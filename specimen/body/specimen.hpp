/// A specimen: mask, aggregates, ITZ rings, and where all of it came from.
/// What a specimen must hold to be worth keeping or breaking.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/body/ring.hpp"

namespace specimen {

/// Where a specimen came from, so that it can be made again.
struct Provenance {
  std::string source;      ///< "generated", "ellipse list", or the name of the picture (no folder)
  std::string sha256;      ///< of the source file, lower-case hexadecimal; empty when generated
  std::string options;     ///< the options as the program resolved them, TOML text
  std::uint64_t seed = 0;  ///< of the random ellipses; 0 when none were drawn
  std::string version;     ///< of mesopix
  friend bool operator==(const Provenance&, const Provenance&) = default;
};

/// What simulate breaks.
struct Specimen {
  LabelledMask mask;
  std::vector<Inclusion> inclusions;
  ItzOptions itz;
  std::vector<Ring> rings;  ///< one per inclusion (none for ItzMode::none); in mode `points` their vertices
                            ///< are the extra material points
  Provenance provenance;
};

/// Mask and instances before the ITZ is drawn: what both the ellipses and the pictures lead to.
struct Segmented {
  LabelledMask mask;               ///< void, aggregate, mortar and the user's own phases
  Raster<std::int32_t> instances;  ///< 0 = no aggregate, else the id of the inclusion; same shape as the mask
  std::vector<Inclusion> inclusions;  ///< ids are 1 ... n in this order
};

/// Rings round every inclusion, drawn into the mask as the options say.
[[nodiscard]] Specimen make_specimen(Segmented segmented, const ItzOptions& itz, Provenance provenance);

/// Segmented picture of a list of ellipses: mortar everywhere, aggregate where a pixel's centre is inside.
/// @throws Error when two ellipses overlap or one leaves the specimen, with their numbers.
[[nodiscard]] Segmented draw_ellipses(const std::vector<Ellipse>& ellipses, double width, double height,
                                      double pixel_size);

/// The same through a window, whose border may cut ellipses. What lies outside, or between the centres of
/// pixels, is left out; ids follow the order of the others. An inclusion that is cut has a contour.
/// @pre the ellipses do not overlap.   @throws Error for a size that is no whole number of pixels.
[[nodiscard]] Segmented draw_window(const std::vector<Ellipse>& ellipses, double width, double height,
                                    double pixel_size);

/// Sizes beyond which a specimen is refused, whatever memory there is; a file is refused on its header,
/// before any memory is asked for.
inline constexpr std::int64_t max_pixels = 200'000'000;
inline constexpr std::int64_t max_inclusions = 4'000'000;
inline constexpr std::int64_t max_points = 100'000'000;  ///< of all contours, and of all rings

/// Check a specimen: extents, scale, phase names, labels within them, inclusions with ids of their own and
/// finite figures, rings that belong to one of them.
/// @throws Error naming the first thing that is wrong, e.g. "rings[2].inclusion".
void validate(const Specimen& specimen);

}  // namespace specimen
