#include "libmpm/solver/quasi_static/lattice_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/solver/grid.hpp"

namespace mpm {
namespace {

/// Failures are looked for where the sweeps do not.
Plan without_checks(Plan plan) {
  plan.features.check = kernels::Check::none;
  plan.features.crack_closure = false;
  return plan;
}

}  // namespace

LatticeCells::LatticeCells(const Scene& scene, const Plan& plan, const StrengthFactors& factors)
    : scene_(scene),
      plan_(without_checks(plan)),
      points_(make_points<double>(scene, plan_, factors)),
      extra_(make_extra_points(scene, plan_)),
      separate_(plan.cells_y,
                plan.features.crack_closure || !extra_.points.empty() ? points_in_all() : std::size_t{0}),
      stiffness_(scene),
      sweep_cells_(chosen_kernels(scene.instruction_set).cells<double>(plan_.features)),
      sweep_corrections_(chosen_kernels(scene.instruction_set).corrections(plan_.features)) {
  round_points();
  for (const auto& phase : scene.phases)
    intact_.push_back(!phase                            ? 0
                      : plan.features.one_poisson_ratio ? phase->young
                                                        : mpm::stiffness(*phase, scene.plane)(2, 2));
  Phase unit;
  unit.young = 1;
  unit.poisson = plan.poisson;
  unit_stiffness_ = mpm::stiffness(unit, scene.plane);
  if (extra_.points.empty()) return;
  points_of_pixels_ = points_per_pixel(scene);
  for (int row = 0; row < plan_.cells_y; ++row)
    each_extra(row, [&](const PointPlace& at) { (void)keep(at, 1); });
}

void LatticeCells::take_over(const AlignedVector<double>& stiffness, const AlignedVector<double>& shear) {
  points_.stiffness = stiffness;
  points_.shear = shear;
  round_points();
}

void LatticeCells::round_points() {
  single_.stiffness.assign(points_.stiffness.begin(), points_.stiffness.end());
  single_.shear.assign(points_.shear.begin(), points_.shear.end());
}

/// All of one precision.
template <class Real>
kernels::CellRow<Real, Real> LatticeCells::cell_row(int row, const NodeFieldOf<Real>& u,
                                                    kernels::NodeForces<Real> lower,
                                                    kernels::NodeForces<Real> upper) const {
  const std::size_t below = shape().node(row, 0);
  const std::size_t above = shape().node(row + 1, 0);
  const auto& [stiffness, shear] = [&] {
    if constexpr (sizeof(Real) == sizeof(float))
      return std::tie(single_.stiffness, single_.shear);
    else
      return std::tie(points_.stiffness, points_.shear);
  }();
  return {.cells = static_cast<int>(points_.stride),
          .stride = points_.stride,
          .ux_lower = u.x.data() + below,
          .uy_lower = u.y.data() + below,
          .ux_upper = u.x.data() + above,
          .uy_upper = u.y.data() + above,
          .stiffness = stiffness.data() + points_.row(row),
          .shear = shear.empty() ? nullptr : shear.data() + points_.row(row),
          .tension = nullptr,
          .crush = nullptr,
          .cracked = nullptr,
          .unilateral = 0,
          .unit_axial = static_cast<Real>(unit_stiffness_(0, 0)),
          .unit_lateral = static_cast<Real>(unit_stiffness_(0, 1)),
          .unit_shear = static_cast<Real>(unit_stiffness_(2, 2)),
          .unit_bending = static_cast<Real>(bending_stiffness(unit_stiffness_)),
          .lower = lower,
          .upper = upper,
          .suspects = nullptr};
}

void LatticeCells::forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
                          kernels::NodeForces<double> upper) const {
  const auto cells = cell_row(row, u, lower, upper);
  (void)sweep_cells_(cells);
  if (!separate_.empty()) separate_.add_forces(row, cells);
}

void LatticeCells::correction_forces(int row, const NodeFieldOf<float>& u, kernels::NodeForces<float> lower,
                                     kernels::NodeForces<float> upper) const {
  const auto cells = cell_row(row, u, lower, upper);
  (void)sweep_corrections_(cells);
  if (!separate_.empty()) separate_.add_correction_forces(row, cells);
}

void LatticeCells::correction_forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
                                     kernels::NodeForces<double> upper) const {
  const auto cells = cell_row(row, u, lower, upper);
  (void)sweep_cells_(cells);
  if (!separate_.empty()) separate_.add_correction_forces(row, cells);
}

/// Of the phases that are there: the largest stiffness of one against a strain along an axis over the
/// smallest one against shear.
double LatticeCells::contrast() const {
  std::array<bool, 256> is_there{};
  for (const std::uint8_t label : scene_.labels.reshaped()) is_there[label] = true;
  for (const ExtraPoint& point : scene_.extra_points) is_there[point.phase] = true;
  double stiffest = 0;
  double softest = std::numeric_limits<double>::infinity();
  for (std::size_t label = 0; label < scene_.phases.size(); ++label) {
    if (!is_there[label] || !scene_.phases[label]) continue;
    const Eigen::Matrix3d c = mpm::stiffness(*scene_.phases[label], scene_.plane);
    stiffest = std::max(stiffest, c(0, 0));
    softest = std::min(softest, c(2, 2));
  }
  return stiffest / softest;
}

Pixel LatticeCells::pixel(const PointPlace& at) const {
  const int k = scene_.points_per_cell;
  return {static_cast<int>(scene_.labels.rows()) - 1 - (at.row * k + at.plane / k),
          at.cell * k + at.plane % k};
}

const std::uint8_t* LatticeCells::label(const PointPlace& at) const {
  if (is_extra(at)) return &scene_.extra_points[extra(at).index].phase;
  const Pixel where = pixel(at);
  if (where.row < 0 || where.col >= scene_.labels.cols()) return nullptr;
  const std::uint8_t& label = scene_.labels(where.row, where.col);
  return scene_.phases[label] ? &label : nullptr;
}

LatticeCells::InCell LatticeCells::in_cell(const PointPlace& at) const {
  if (is_extra(at)) return {extra(at).xi, extra(at).eta};
  const int k = scene_.points_per_cell;
  return {(at.plane % k + 0.5) / k, (at.plane / k + 0.5) / k};
}

double LatticeCells::share(const PointPlace& at) const {
  if (is_extra(at)) return extra(at).share;
  if (points_of_pixels_.size() == 0) return 1;
  const Pixel where = pixel(at);
  return 1.0 / points_of_pixels_(where.row, where.col);
}

double LatticeCells::share_of(std::uint8_t label, std::size_t at) const {
  return (plan_.features.one_poisson_ratio ? points_.stiffness[at] : points_.shear[at]) / intact_[label];
}

double LatticeCells::kept(const PointPlace& at) const {
  const std::uint8_t* of = label(at);
  if (of == nullptr) return 0;
  if (const auto state = separate_.state(index(at))) return state->kept;
  return share_of(*of, index(at)) / share(at);
}

CellModes LatticeCells::cell(int row, int col) const {
  CellModes sum = CellModes::Zero();
  for (int plane = 0; plane < points_.planes; ++plane)
    if (const std::uint8_t* of = label({row, plane, col}))
      sum += share_of(*of, points_.at(row, plane, col)) * stiffness_.of(*of, plane);
  if (!separate_.empty()) sum += separate_.in_cell(row, col);
  return sum;
}

bool LatticeCells::keep(const PointPlace& at, double share, double cracked) {
  const std::uint8_t* of = label(at);
  if (of == nullptr) return false;
  const bool separate = is_extra(at) || cracked > 0;
  if (separate)
    put_separate(at, *of, share, cracked);
  else
    separate_.remove(at.row, index(at));
  if (!is_extra(at)) store(index(at), *of, separate ? 0 : share * this->share(at));
  return true;
}

void LatticeCells::put_separate(const PointPlace& at, std::uint8_t label, double kept, double cracked) {
  const InCell place = in_cell(at);
  const Eigen::Matrix3d elastic = share(at) * mpm::stiffness(*scene_.phases[label], scene_.plane);
  separate_.put({at, index(at), place.xi, place.eta}, {elastic, scene_.pixel_cells && !is_extra(at)},
                {kept, cracked});
}

/// @param share  of the stiffness of a whole pixel [-].
void LatticeCells::store(std::size_t at, std::uint8_t label, double share) {
  const Phase& phase = *scene_.phases[label];
  if (plan_.features.one_poisson_ratio) {
    points_.stiffness[at] = phase.young * share;
  } else {
    const Eigen::Matrix3d c = mpm::stiffness(phase, scene_.plane);
    points_.stiffness[at] = c(0, 1) * share;
    points_.shear[at] = c(2, 2) * share;
    single_.shear[at] = static_cast<float>(points_.shear[at]);
  }
  single_.stiffness[at] = static_cast<float>(points_.stiffness[at]);
}

}  // namespace mpm
