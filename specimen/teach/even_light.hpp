/// Light that changes slowly over a picture, and how it is evened out.
#pragma once

#include "specimen/body/raster.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {

/// Even out the light. A surface of second order in the place is fitted to the lightness of some 1,000 blocks
/// of the picture, so that blocks of a darker or lighter phase count little or not at all (Tukey's weights);
/// then L + 16, a and b of each pixel are multiplied by its mean over its value there. All three go with the
/// cube root of the intensity, so that this is what the pixel would look like in even light.
/// @return how many times as bright as the darkest place the brightest one was lit [-], >= 1.
/// Source: Beaton, Tukey (1974), the weights; CIE 15, the cube root.
double even_light(Raster<Lab>& picture);

}  // namespace specimen
