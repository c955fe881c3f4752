/// What speaks against a specimen that was made from a picture.
#pragma once

#include <string>
#include <vector>

#include "specimen/body/specimen.hpp"

namespace specimen {

/// What hardly any concrete is like, so that the picture, its scale or its reading is probably wrong; a
/// sentence each. None for a specimen that was generated, or drawn from a list of ellipses: that is as it was
/// asked for.
/// - void on more than 30 %, aggregate on more than 80 % of the area, one aggregate on more than 50 %;
/// - no aggregate, or more than 2,000 of at most nine pixels;
/// - a width below 2 mm or above 10 m;
/// - and what its provenance warns of.
[[nodiscard]] std::vector<std::string> doubts_of(const Specimen& specimen);

}  // namespace specimen
