/// What holds the edges of the grid: platens, walls, planes of symmetry.
#pragma once

#include "libmpm/scene.hpp"

namespace mpm {

struct Support {
  bool active = false;     ///< something stands there
  bool separates = false;  ///< the specimen may part from it
  bool rough = false;      ///< what touches it does not slide
  double velocity = 0;     ///< of its own, in the direction of x or y [m/s]

  /// Velocity of a node at the support, from the free one. `outward` is +1 at the right and upper edge, else
  /// -1.
  struct Velocity {
    double normal = 0, tangential = 0;  ///< [m/s]
  };
  [[nodiscard]] Velocity held(Velocity free, int outward) const {
    if (!active || (separates && outward * (free.normal - velocity) <= 0)) return free;
    return {velocity, rough ? 0.0 : free.tangential};
  }
};

/// The four edges.
struct Supports {
  Support left, right, bottom, top;
};

/// Supports of a scene; the top platen stands still.
[[nodiscard]] Supports supports_of(const Scene& scene);

}  // namespace mpm
