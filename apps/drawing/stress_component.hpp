/// What of the stress at a point a picture shows.
#pragma once

#include <string>

#include "libmpm/solver/frame.hpp"

namespace output {

/// first and third are the largest and the smallest of the three principal stresses, that out of the plane
/// included.
enum class StressComponent { yy, xx, xy, first, third, mises };

/// Of what the point carries [Pa]; tension is positive.
[[nodiscard]] double stress_of(const mpm::FramePoint& point, StressComponent component);

/// "stress in the direction of loading".
/// @param loaded  between platens, which move along y.
[[nodiscard]] std::string phrase_of(StressComponent component, bool loaded);

}  // namespace output
