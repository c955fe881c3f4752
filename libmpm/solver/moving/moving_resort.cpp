// Points that left their tile: to the one that they are in, or out of the grid.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "libmpm/solver/moving/moving_solver.hpp"

namespace mpm {

namespace {

/// Of a point that is not to be found in the next tile.
template <class Loose>
std::string what_went_wrong(const Loose& point) {
  const bool is_number = std::isfinite(point.values[moving::xi]) && std::isfinite(point.values[moving::eta]);
  return is_number ? "a point moves more than a cell in a step, " : "a position is not a number, that of ";
}

}  // namespace

/// Points that left their tile go to the one that they are in, in the order of the rows they came from,
/// whatever the number of bands.
template <class Real>
void MovingSolver<Real>::resort() {
  for (Band& band : bands_) {
    std::stable_sort(band.movers.begin(), band.movers.end(),
                     [](const Loose& a, const Loose& b) { return a.tile.row < b.tile.row; });
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
        stop(what_went_wrong(point) + name_of_point(scene_, point.id) +
             "; the time step is too long: try a smaller solver.cfl");
        continue;
      }
      if (is_inside(point) || stays_at_support(point))
        points_.insert(point);
      else
        leave(point);
    }
    band.movers.clear();
  }
}

template <class Real>
bool MovingSolver<Real>::is_inside(const Loose& point) const {
  return point.tile.row >= 0 && point.tile.row < geometry_.tiles_y && point.tile.col >= 0 &&
         point.tile.col < geometry_.tiles_x;
}

/// A point that stands on a platen, a wall or a plane of symmetry has nothing but rounding to carry it
/// beyond, and is put back.
template <class Real>
bool MovingSolver<Real>::stays_at_support(Loose& point) const {
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  const auto put_back = [](int& tile, Real& place, int tiles, const Support& before, const Support& behind) {
    if (tile == -1 && before.active && place > 1 - rounding) {
      tile = 0;
      place = 0;
    } else if (tile == tiles && behind.active && place < rounding) {
      tile = tiles - 1;
      place = std::nextafter(Real(1), Real(0));
    }
  };
  put_back(point.tile.col, point.values[moving::xi], geometry_.tiles_x, supports_.left, supports_.right);
  put_back(point.tile.row, point.values[moving::eta], geometry_.tiles_y, supports_.bottom, supports_.top);
  return is_inside(point);
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
    stop(std::string("a point left the grid at the ") + name + " edge, " + name_of_point(scene_, point.id) +
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
