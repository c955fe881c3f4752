/// A picture of damage with all that a reader needs beside it.
#pragma once

#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/drawing.hpp"

namespace output {

/// Damage at a platen strain [-], with a scale bar, a legend of what is in it, and a line of words below.
/// @pre as damage_picture.
[[nodiscard]] Drawing damage_drawing(const specimen::LabelledMask& mask, const mpm::Result& result,
                                     double strain, const Palette& palette, const std::string& words);

}  // namespace output
