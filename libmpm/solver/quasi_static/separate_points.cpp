#include "libmpm/solver/quasi_static/separate_points.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

namespace mpm {
namespace {

/// Share of its stiffness that an open crack keeps, so that its faces stay where they are.
constexpr double open_remainder = 1e-6;
/// Change of a stiffness over itself that a preconditioner bears: it must stay below the factor of 4.9 at
/// which the smoothing of the multigrid begins to diverge, and is 4 at most for a stiffness that it knows.
constexpr double borne = 0.2;

constexpr int triangle_row[6] = {0, 0, 0, 1, 1, 2};
constexpr int triangle_col[6] = {0, 1, 2, 1, 2, 2};

/// What an entirely cracked point has left.
Eigen::Matrix3d closed_stiffness(const Eigen::Matrix3d& elastic, const Eigen::Vector3d& strain) {
  const double difference = strain[0] - strain[1];
  const double radius = std::hypot(difference, strain[2]);
  const double first = 0.5 * (strain[0] + strain[1] + radius);
  const double second = 0.5 * (strain[0] + strain[1] - radius);
  if (elastic(0, 0) * first + elastic(0, 1) * second <= 0) return elastic;  // nothing opens
  if (second >= 0) return Eigen::Matrix3d::Zero();
  // Along the crack a bar that is pressed, and that turns with the strain.
  const double ratio = elastic(0, 1) / elastic(0, 0);
  const double bar = elastic(0, 0) * (1 - ratio * ratio);
  const double cosine = difference / radius;  // of twice the angle of the largest strain
  const double sine = strain[2] / radius;
  const Eigen::Vector3d along(0.5 * (1 - cosine), 0.5 * (1 + cosine), -0.5 * sine);
  const Eigen::Vector3d turning(-sine, sine, cosine);
  return bar * along * along.transpose() -
         0.5 * bar * second / (first - second) * turning * turning.transpose();
}

/// From the modes of a cell to the strain at a place in it, see CellModes.
Eigen::Matrix<double, 3, 5> strain_of_modes(double xi, double eta) {
  Eigen::Matrix<double, 3, 5> strain = Eigen::Matrix<double, 3, 5>::Zero();
  strain(0, 0) = strain(1, 1) = strain(2, 2) = 0.5;
  strain(0, 3) = strain(2, 4) = eta - 0.5;
  strain(1, 4) = strain(2, 3) = xi - 0.5;
  return strain;
}

bool preconditions(const Eigen::Matrix3d& told, const Eigen::Matrix3d& now) {
  if (told == now) return true;
  const Eigen::LLT<Eigen::Matrix3d> factors(told);
  if (factors.info() != Eigen::Success) return false;
  const Eigen::Matrix3d half = factors.matrixL().solve(now);
  const Eigen::Matrix3d ratio = factors.matrixL().solve(half.transpose());
  return (ratio - Eigen::Matrix3d::Identity()).norm() <= borne;
}

}  // namespace

Eigen::Matrix3d cracked_stiffness(const Eigen::Matrix3d& elastic, double cracked,
                                  const Eigen::Vector3d& strain) {
  if (cracked <= 0) return elastic;
  const double lost = std::min(cracked, 1 - open_remainder);
  return (1 - lost) * elastic + lost * closed_stiffness(elastic, strain);
}

void SeparatePoints::take_stiffness(Point& point, double caution, const CellDisplacement& u) {
  const Eigen::Matrix3d elastic = point.state.kept * point.kind.elastic;
  point.now = point.cautious = point.bound = elastic;
  if (point.state.cracked <= 0) return;
  const double xi = point.place.xi;
  const double eta = point.place.eta;
  const auto along_x = [&](const double(&v)[4]) { return (1 - eta) * (v[1] - v[0]) + eta * (v[3] - v[2]); };
  const auto along_y = [&](const double(&v)[4]) { return (1 - xi) * (v[2] - v[0]) + xi * (v[3] - v[1]); };
  const Eigen::Matrix3d closed =
      closed_stiffness(elastic, {along_x(u.ux), along_y(u.uy), along_y(u.ux) + along_x(u.uy)});
  const auto open_with = [&](double remainder) -> Eigen::Matrix3d {
    const double lost = std::min(point.state.cracked, 1 - remainder);
    return (1 - lost) * elastic + lost * closed;
  };
  point.now = open_with(open_remainder);
  point.cautious = open_with(std::max(caution, open_remainder));
  point.bound = open_with(most_caution);
}

double SeparatePoints::bending_of(const Point& point) {
  if (!point.kind.resists_bending) return 0;
  return point.state.kept * std::max(1 - point.state.cracked, open_remainder) *
         bending_stiffness(point.kind.elastic);
}

void SeparatePoints::write(Row& row) {
  const auto take = [&](auto& acting, const auto& stiffness) {
    using Real = std::remove_cvref_t<decltype(acting.front().xi)>;
    acting.resize(row.points.size());
    for (std::size_t i = 0; i < row.points.size(); ++i) {
      const Point& point = row.points[i];
      acting[i].cell = point.place.at.cell;
      acting[i].xi = static_cast<Real>(point.place.xi);
      acting[i].eta = static_cast<Real>(point.place.eta);
      acting[i].bending = static_cast<Real>(bending_of(point));
      for (int e = 0; e < 6; ++e)
        acting[i].stiffness[e] = static_cast<Real>((point.*stiffness)(triangle_row[e], triangle_col[e]));
    }
  };
  take(row.exact, &Point::now);
  take(row.cautious, &Point::cautious);
  take(row.single, &Point::cautious);
}

void SeparatePoints::put(const Place& place, const Kind& kind, const State& state) {
  const std::size_t had = has(place.index) && states_[place.index].cracked > 0 ? 1 : 0;
  std::vector<Point>& points = rows_[static_cast<std::size_t>(place.at.row)].points;
  auto point =
      std::lower_bound(points.begin(), points.end(), place, [](const Point& one, const Place& wanted) {
        return std::pair(one.place.at.cell, one.place.index) < std::pair(wanted.at.cell, wanted.index);
      });
  if (!has(place.index)) {
    const Eigen::Matrix3d none = Eigen::Matrix3d::Zero();
    point = points.insert(point, Point{place, kind, state, none, none, none, none});
    ++count_;
  }
  point->state = state;
  states_[place.index] = state;
  cracked_ += (state.cracked > 0 ? 1 : 0) - had;
}

void SeparatePoints::remove(int row, std::size_t index) {
  if (!has(index)) return;
  std::erase_if(rows_[static_cast<std::size_t>(row)].points,
                [&](const Point& point) { return point.place.index == index; });
  --count_;
  if (states_[index].cracked > 0) --cracked_;
  states_[index].kept = -1;
}

std::vector<SeparatePoints::Cell> SeparatePoints::changed() {
  std::vector<Cell> cells;
  for (Row& row : rows_)
    for (Point& point : row.points) {
      if (preconditions(point.told, point.bound)) continue;
      point.told = point.bound;
      cells.push_back({point.place.at.row, point.place.at.cell});
    }
  return cells;
}

template <class Real>
void SeparatePoints::add(const std::vector<Acting<Real>>& points, const kernels::CellRow<Real, Real>& in) {
  for (const Acting<Real>& p : points) {
    const int i = p.cell;
    const Real near_x = 1 - p.xi;
    const Real near_y = 1 - p.eta;
    const Real low_x = in.ux_lower[i + 1] - in.ux_lower[i];
    const Real high_x = in.ux_upper[i + 1] - in.ux_upper[i];
    const Real low_y = in.uy_lower[i + 1] - in.uy_lower[i];
    const Real high_y = in.uy_upper[i + 1] - in.uy_upper[i];
    const Real exx = near_y * low_x + p.eta * high_x;
    const Real eyy =
        near_x * (in.uy_upper[i] - in.uy_lower[i]) + p.xi * (in.uy_upper[i + 1] - in.uy_lower[i + 1]);
    const Real gxy = near_x * (in.ux_upper[i] - in.ux_lower[i]) +
                     p.xi * (in.ux_upper[i + 1] - in.ux_lower[i + 1]) + near_y * low_y + p.eta * high_y;
    const Real* c = p.stiffness;
    const Real xx = c[0] * exx + c[1] * eyy + c[2] * gxy;
    const Real yy = c[1] * exx + c[3] * eyy + c[4] * gxy;
    const Real xy = c[2] * exx + c[4] * eyy + c[5] * gxy;
    const Real bent_x = p.bending * (high_x - low_x);
    const Real bent_y = p.bending * (high_y - low_y);
    in.lower.left_x[i] += near_y * xx + near_x * xy - bent_x;
    in.lower.right_x[i] += p.xi * xy - near_y * xx + bent_x;
    in.upper.left_x[i] += p.eta * xx - near_x * xy + bent_x;
    in.upper.right_x[i] -= p.eta * xx + p.xi * xy + bent_x;
    in.lower.left_y[i] += near_x * yy + near_y * xy - bent_y;
    in.lower.right_y[i] += p.xi * yy - near_y * xy + bent_y;
    in.upper.left_y[i] += p.eta * xy - near_x * yy + bent_y;
    in.upper.right_y[i] -= p.xi * yy + p.eta * xy + bent_y;
  }
}

void SeparatePoints::add_forces(int row, const kernels::CellRow<double, double>& in) const {
  add(rows_[static_cast<std::size_t>(row)].exact, in);
}
void SeparatePoints::add_correction_forces(int row, const kernels::CellRow<double, double>& in) const {
  add(rows_[static_cast<std::size_t>(row)].cautious, in);
}
void SeparatePoints::add_correction_forces(int row, const kernels::CellRow<float, float>& in) const {
  add(rows_[static_cast<std::size_t>(row)].single, in);
}

CellModes SeparatePoints::in_cell(int row, int cell) const {
  CellModes sum = CellModes::Zero();
  const std::vector<Point>& points = rows_[static_cast<std::size_t>(row)].points;
  auto point = std::lower_bound(points.begin(), points.end(), cell,
                                [](const Point& one, int wanted) { return one.place.at.cell < wanted; });
  for (; point != points.end() && point->place.at.cell == cell; ++point) {
    const Eigen::Matrix<double, 3, 5> strain = strain_of_modes(point->place.xi, point->place.eta);
    sum += strain.transpose() * point->told * strain;
    sum(3, 3) += bending_of(*point);
    sum(4, 4) += bending_of(*point);
  }
  return sum;
}

std::vector<SeparatePoints::Told> SeparatePoints::told() const {
  std::vector<Told> all;
  for (const Row& row : rows_)
    for (const Point& point : row.points) {
      Told& told = all.emplace_back();
      for (std::size_t e = 0; e < told.size(); ++e) told[e] = point.told(triangle_row[e], triangle_col[e]);
    }
  return all;
}

bool SeparatePoints::set_told(const std::vector<Told>& all) {
  if (all.size() != count_) return false;
  for (const Told& told : all)
    if (!std::all_of(told.begin(), told.end(), [](double value) { return std::isfinite(value); }))
      return false;
  auto told = all.begin();
  for (Row& row : rows_)
    for (Point& point : row.points) {
      for (std::size_t e = 0; e < told->size(); ++e)
        point.told(triangle_row[e], triangle_col[e]) = point.told(triangle_col[e], triangle_row[e]) =
            (*told)[e];
      ++told;
    }
  return true;
}

}  // namespace mpm
