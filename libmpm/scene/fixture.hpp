/// How a laboratory test holds, loads and measures a specimen, where platens along two whole edges do not say
/// it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace mpm {

/// A side of the specimen.
enum class Side { bottom, top, left, right };

/// A part of the outline of the specimen, as it is seen from one side: in each row or column of nodes the
/// outermost one with material, of these the outermost level, as a flat plate touches it. Of a stretch that
/// is shorter than a cell it is the nearest node.
struct Stretch {
  Side side = Side::bottom;
  double from = 0;  ///< along the side, from the lower left corner of the specimen [m]
  double to = std::numeric_limits<double>::infinity();  ///< [m], >= from
};

/// Nodes that do not move.
struct Bearing {
  Stretch at;
  bool fix_x = false, fix_y = true;  ///< along which axes
};

/// The sense of a displacement.
enum class Way { up, down, left, right };

/// Nodes that are moved. One load leads: the platen displacement of the history is its own, and all others
/// keep their share of it.
struct Load {
  Stretch at;
  Way way = Way::down;
  double share = 1;    ///< displacement over that of the leading load [-]; 1 for that
  bool leads = false;  ///< exactly one does
  bool grips = false;  ///< holds its nodes across its way too, as a rough platen does
};

/// A gauge between two points of the specimen: how far they have moved apart.
struct Gauge {
  enum class Direction { x, y, along };
  std::string name;                        ///< unlike that of the others
  double x1 = 0, y1 = 0, x2 = 0, y2 = 0;   ///< from the lower left corner [m]
  Direction direction = Direction::along;  ///< along x, along y, or along the line between the points
  std::optional<double> until = {};        ///< reading at which the run ends [m], > 0
  bool controls = false;  ///< its reading never falls, so that the load may snap back; at most one does
};

/// Without loads the specimen stands between platens.
struct Fixture {
  std::vector<Bearing> supports;
  std::vector<Load> loads;
  std::vector<Gauge> gauges;
  double thickness = 1;  ///< of the specimen out of the plane, for forces in newtons [m], > 0

  [[nodiscard]] bool has_loads() const { return !loads.empty(); }
  /// The load that leads; nullptr without loads.
  [[nodiscard]] const Load* leading() const {
    for (const Load& load : loads)
      if (load.leads) return &load;
    return nullptr;
  }
  /// The gauge that controls the run; nullptr if it is the displacement of the load.
  [[nodiscard]] const Gauge* controlling() const {
    for (const Gauge& gauge : gauges)
      if (gauge.controls) return &gauge;
    return nullptr;
  }
};

}  // namespace mpm
