/// Boundaries brought to where the colours on their two sides part.
#pragma once

#include "specimen/body/raster.hpp"
#include "specimen/picture/image_colour.hpp"
#include "specimen/teach/edge_smoothing.hpp"

namespace specimen {

struct LocalColoursOptions {
  int window = 12;     ///< radius of the surroundings whose colours are learnt [px], >= 3
  int steps = 6;       ///< of the exchange between neighbours
  float trust = 0.3F;  ///< weight of the colour of one pixel beside its share: pixels side by side look alike
  float bond = 1;      ///< between neighbours of the same colour
  float contrast = 6;  ///< difference of colour that loosens the bond [L]
  float noise = 3;     ///< deviation that every colour has at least [L]
  float common = 0.01F;  ///< weight of the colours of a class in the whole picture beside those near by
};

/// Sharpen shares by the colours round each pixel. Of each class, mean and deviation of L, a and b are taken
/// over the pixels near by that are likely of this class. By these normal distributions, by its share and by
/// its neighbours each pixel is weighed anew: neighbours bind the more, the more alike their colours are. So
/// a boundary that lies some pixels off, as windows over two phases put it, moves to where the colours part.
/// @param shares  of the classes.   @param picture  in the shape of the shares.
/// The same bits on any number of threads.
/// Sources: statistics in the surroundings, Lankton, Tannenbaum (2008); bonds and contrast, Rother,
/// Kolmogorov, Blake (2004); the exchange, which is a mean field, Kraehenbuehl, Koltun (2011).
[[nodiscard]] ClassShares sharpened_by_colours(const ClassShares& shares, const Raster<Lab>& picture,
                                               const LocalColoursOptions& options, int threads);

}  // namespace specimen
