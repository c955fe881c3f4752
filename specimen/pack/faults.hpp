/// All that is wrong with a specimen that is to be drawn, at once; who draws it throws the first of it.
#pragma once

#include <string>
#include <vector>

#include "specimen/body/error.hpp"
#include "specimen/pack/packing.hpp"

namespace specimen {

/// Every option that is out of range; none of options that can be tried.
[[nodiscard]] std::vector<Error> faults(const PackingOptions& options);

/// Every one of the three sizes [m] that is not positive or no whole number of pixels, or makes too many of
/// them.   @param group  of the fields in errors: "generate".
[[nodiscard]] std::vector<Error> canvas_faults(double width, double height, double pixel_size,
                                               const std::string& group);

}  // namespace specimen
