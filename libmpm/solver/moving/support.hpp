/// What holds the edges of the grid: platens, walls, planes of symmetry.
#pragma once

#include <optional>

#include "libmpm/scene/scene.hpp"

namespace mpm {

struct Support {
  bool active = false;     ///< something stands there
  bool separates = false;  ///< the specimen may part from it
  bool rough = false;      ///< what touches it does not slide
  double velocity = 0;     ///< of its own in this step, in the direction of x or y [m/s]
  double before = 0;       ///< in the step before [m/s]

  /// Velocity along an axis that a support gives to a node, and that which the node is taken to have had
  /// [m/s].
  struct Held {
    double velocity = 0, before = 0;
  };
  /// What the support does to a node across it, nothing when the node parts from it or the support is not
  /// there.
  ///
  /// A node that stays at its support had the support's velocity, not the mean of the points beside it, which
  /// do not all move as it does: FLIP would else take from them, step by step, what sets them apart. So a
  /// plane of symmetry stands for the other half of a body. A node that a support with separation catches
  /// comes with what its points brought.
  /// @param brought  velocity of the points [m/s].   @param change  what the forces of the step add to it
  /// [m/s].
  /// @param outward  +1 at the right and upper edge, else -1.   @param touched  in the step before.
  [[nodiscard]] std::optional<Held> caught(double brought, double change, int outward, bool touched) const {
    if (!active) return std::nullopt;
    const bool stays = touched && outward * (before + change - velocity) > 0;
    if (!separates || stays) return Held{velocity, before};
    if (outward * (brought + change - velocity) > 0) return Held{velocity, brought};
    return std::nullopt;
  }
};

/// The four edges.
struct Supports {
  Support left, right, bottom, top;
};

/// Supports of a scene; the top platen stands still.
[[nodiscard]] Supports supports_of(const Scene& scene);

}  // namespace mpm
