/// What holds, moves and measures the nodes of a run: the fixture of its scene, found once on its grid.
#pragma once

#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// A node that is held or moved along one axis or both. Row 0 is the lowest.
struct HeldNode {
  int row = 0, col = 0;
  bool x = false, y = false;  ///< along which axes its displacement is given
  double ux = 0, uy = 0;      ///< that, over the displacement of the leading load [-]
  int load = -1;              ///< number of the load that moves it; -1 = none
};

/// What counts of the displacement of a node for a gauge [-].
struct NodeWeight {
  int row = 0, col = 0;
  double x = 0, y = 0;
};

/// Empty for a specimen between platens.
struct GridBoundary {
  std::vector<HeldNode> held;                   ///< by row, then by column; each once
  std::vector<std::vector<NodeWeight>> gauges;  ///< in the order of the scene

  [[nodiscard]] bool empty() const { return held.empty(); }
};

/// @param cells_x, cells_y  of the grid.   @param cell_size  [m].
/// @throws Error for a stretch without material, nodes that are to move in two ways, gauges beside the
/// material, and a specimen that can move as a whole.
[[nodiscard]] GridBoundary find_boundary(const Scene& scene, int cells_x, int cells_y, double cell_size);

/// The sense of a way along x and y [-].
[[nodiscard]] double sense_x(Way way);
[[nodiscard]] double sense_y(Way way);

}  // namespace mpm
