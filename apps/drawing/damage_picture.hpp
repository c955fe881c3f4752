/// Pictures of damage at a strain.
#pragma once

#include <array>

#include "libmpm/scene/result.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/picture/picture.hpp"

namespace output {

/// What each phase and each failure looks like.
struct Palette {
  std::array<specimen::Rgb, 256> phases{};  ///< by label
  specimen::Rgb tension;
  specimen::Rgb shear;
};

/// As in the paper: white aggregate, light grey mortar, dark grey shear failures, black tension failures; the
/// ITZ a little darker than the mortar, voids middle grey.
[[nodiscard]] Palette grey_palette();

/// Phases in pale shades of the colours of the preview; tension failures dark blue, shear failures vermilion,
/// which differ in hue and in lightness for every kind of colour vision.
[[nodiscard]] Palette colour_palette();

/// Failure of a pixel at a platen strain, as it looked then. A point that cracked and was crushed later has
/// failed in shear from its crushing on.
[[nodiscard]] mpm::FailureMode failure_at(const mpm::Result& result, Eigen::Index pixel, double strain);

/// Damage at a platen strain [-], one pixel a pixel, row 0 on top as in the mask.
/// @pre the maps of the result have the shape of the mask, or are empty: nothing can fail.
[[nodiscard]] specimen::Raster<specimen::Rgb> damage_picture(const specimen::LabelledMask& mask,
                                                             const mpm::Result& result, double strain,
                                                             const Palette& palette);

}  // namespace output
