/// Ellipses of given axes laid into a room: at random where there is place, pushed apart where there is not.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "specimen/body/ellipse.hpp"
#include "specimen/pack/placement.hpp"
#include "specimen/body/random.hpp"
#include "specimen/pack/relaxation.hpp"

namespace specimen {

/// What came of laying ellipses into a room.
struct Settlement {
  bool solved = false;                   ///< every gap is kept
  bool relaxed = false;                  ///< plain placement was not enough
  std::optional<std::size_t> too_large;  ///< the ellipse that fits between the walls at no direction tried
};

/// Largest first, each at the first of its random places that is free; if some find none, all are relaxed.
/// @param ellipses  axes, and with Turning::fixed angles; largest first; they get their centres.
[[nodiscard]] Settlement settle(std::vector<Ellipse>& ellipses, const Room& room, Turning turning,
                                Random& random);

}  // namespace specimen
