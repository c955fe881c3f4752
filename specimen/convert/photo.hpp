/// Colour photographs: classes of pixels by colour, and guesses of their phases.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "specimen/body/raster.hpp"
#include "specimen/convert/classes.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {

/// Classes of a photograph, by increasing lightness.
struct ColourClasses {
  Raster<std::uint8_t> classes;   ///< class per pixel
  std::vector<Position> centres;  ///< L, a, b of each class; then its roughness, if it was used
  bool dark = false;              ///< class 0 was separated as much darker than the rest
  bool flat = false;              ///< the picture is made of this many flat colours
  /// One guess per class if the colours alone are enough, otherwise empty.
  std::vector<std::string> phases;
  std::string reason;  ///< reason for the choice of the classes, a sentence for the user
};

/// k-means in Lab with the lightness at half weight: shading and grain vary in lightness more than in tint.
/// @param count  of classes, >= 2.
[[nodiscard]] ColourClasses colour_classes(const Raster<Lab>& picture, int count);

/// The same with the number of classes taken from the picture:
/// - a drawing of up to 12 flat colours (noisy or not) has one class per colour, but for colours that only
///   smooth edges between two others show; of much darker ones a thousandth of the picture is enough;
/// - a cut with a pink indicator (phenolphthalein): seven classes, of which pink is mortar, an
///   untinted one is aggregate, and one that is between both, darker and browner, is void (the
///   shaded mortar inside a pore);
/// - else two classes by tint, lightness and roughness, each over squares of 2 % of the picture:
///   grains that are cut or worn are smooth beside a sandy matrix; holes and their rims are left out. Classes
///   that pass into each other without edges, as under uneven light, are one.
/// In both of the latter, pixels below half of the median lightness form a separate class: they are
/// holes. Source of the indicator's meaning: EN 14630.
/// @param picture  after a median filter.   @param grainy  the same picture before that, for its roughness.
/// @param has_black  black means that no light comes back; else dark pixels are holes only where they are
/// few.
[[nodiscard]] ColourClasses automatic_classes(const Raster<Lab>& picture, const Raster<Lab>& grainy,
                                              bool has_black = true);

}  // namespace specimen
