/// Inclusions as a table.
#pragma once

#include <string>
#include <vector>

#include "specimen/body/inclusion.hpp"

namespace exchange {

/// Comma-separated values, a line an inclusion, units in the names of the columns: number, centre from the
/// bottom left corner, semi-axes and angle of the ellipse (exact, or that of the same area and second
/// moments), area, perimeter and equivalent diameter, orientation of the long axis. Angles against x,
/// counter-clockwise.
[[nodiscard]] std::string inclusion_table(const std::vector<specimen::Inclusion>& inclusions);

}  // namespace exchange
