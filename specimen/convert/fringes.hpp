/// Label numbers that were resized like grey levels: between 0 and 2 there is a rim of 1, which is another
/// phase.
#pragma once

#include <cstdint>

#include "specimen/convert/guess.hpp"

namespace specimen {

/// Give the pixels of such rims to the values on their sides. A rim is a piece without a middle of 3 x 3
/// pixels between a lower and a higher value, of a value that is a region elsewhere; and rims have to lie
/// along much of the boundary of these two: elsewhere they are small grains.
/// @return how many pixels were given away.
[[nodiscard]] std::int64_t dissolve_fringes(ValueMap& map);

}  // namespace specimen
