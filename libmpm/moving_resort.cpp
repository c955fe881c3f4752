// Points that left their tile: to the one that they are in, or out of the grid.
#include <cmath>
#include <cstdio>
#include <utility>

#include "libmpm/moving_solver.hpp"

namespace mpm {

/// Points that left their tile go to the one that they are in, in the order of the rows they came from,
/// whatever the number of bands.
template <class Real>
void MovingSolver<Real>::resort() {
  for (Band& band : bands_) {
    for (Loose& point : band.movers) {
      const auto step_over = [&](int& tile, Real& place) {
        const Real tiles = std::floor(place);
        if (!(std::abs(tiles) <= 1)) return false;
        tile += static_cast<int>(tiles);
        place -= tiles;
        if (place >= 1) place = std::nextafter(Real(1), Real(0));  // a place just below 0, rounded
        return true;
      };
      const TilePlace from = point.tile;
      if (!step_over(point.tile.col, point.values[moving::xi]) ||
          !step_over(point.tile.row, point.values[moving::eta])) {
        point.tile = from;
        stop("a point moves further than a cell in a step, " + name_of(point.id));
        continue;
      }
      const bool inside = point.tile.row >= 0 && point.tile.row < geometry_.tiles_y && point.tile.col >= 0 &&
                          point.tile.col < geometry_.tiles_x;
      if (inside)
        points_.insert(point);
      else
        leave(point);
    }
    band.movers.clear();
  }
}

template <class Real>
std::string MovingSolver<Real>::name_of(std::uint32_t id) const {
  const PointOrigin origin = origin_of(scene_, id);
  char text[96];
  if (origin.row < 0)
    std::snprintf(text, sizeof text, "extra point %zu", origin.extra);
  else
    std::snprintf(text, sizeof text, "the point of pixel (row %d, column %d)", origin.row, origin.col);
  return text;
}

template <class Real>
void MovingSolver<Real>::leave(const Loose& point) {
  const Motion& motion = scene_.motion;
  const bool sideways = point.tile.col < 0 || point.tile.col >= geometry_.tiles_x;
  const bool first = sideways ? point.tile.col < 0 : point.tile.row < 0;
  const bool platens = scene_.loading.direction != Direction::none;
  const Edge edge = sideways ? (first ? motion.left : motion.right)
                             : (platens ? Edge::symmetry
                                : first ? motion.bottom
                                        : motion.top);
  const char* name = sideways ? (first ? "left" : "right") : (first ? "bottom" : "top");
  if (edge != Edge::open) {
    stop(std::string("a point left the grid at the ") + name + " edge, " + name_of(point.id) +
         (edge == Edge::closed ? std::string("; make motion.margin larger, or motion.") + name + " = \"open\""
                               : std::string()));
    return;
  }
  ++left_;
  left_energy_ += energy_of(point);
  if (point.values[moving::shear] > 0) --live_[origin_of(scene_, point.id).label];
}

/// Kinetic and elastic energy of a point outside of the storage [J/m].
template <class Real>
double MovingSolver<Real>::energy_of(const Loose& point) const {
  MovingPoints<Real> alone(1, 1, sweeps_.lanes, points_.layout());
  Loose copy = point;
  copy.tile = {0, 0};
  alone.insert(copy);
  const moving::Energies energies = sweeps_.measure_energies(alone.tile_row(0, 0), step_);
  return energies.kinetic + energies.elastic;
}

template class MovingSolver<float>;
template class MovingSolver<double>;

}  // namespace mpm
