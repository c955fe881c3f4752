#include "libmpm/solver/quasi_static/lattice_cells.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {
namespace {

/// Failures are looked for where the sweeps do not.
Plan without_checks(Plan plan) {
  plan.features.check = kernels::Check::none;
  plan.features.crack_closure = false;
  return plan;
}

/// A row of cells of points, all of one precision.
template <class Real>
kernels::CellRow<Real, Real> cell_row(const AlignedVector<Real>& stiffness, const AlignedVector<Real>& shear,
                                      std::ptrdiff_t at, std::ptrdiff_t stride, const Eigen::Matrix3d& unit,
                                      const NodeFieldOf<Real>& u, std::size_t below, std::size_t above,
                                      kernels::NodeForces<Real> lower, kernels::NodeForces<Real> upper) {
  return {.cells = static_cast<int>(stride),
          .stride = stride,
          .ux_lower = u.x.data() + below,
          .uy_lower = u.y.data() + below,
          .ux_upper = u.x.data() + above,
          .uy_upper = u.y.data() + above,
          .stiffness = stiffness.data() + at,
          .shear = shear.empty() ? nullptr : shear.data() + at,
          .tension = nullptr,
          .crush = nullptr,
          .cracked = nullptr,
          .unilateral = 0,
          .unit_axial = static_cast<Real>(unit(0, 0)),
          .unit_lateral = static_cast<Real>(unit(0, 1)),
          .unit_shear = static_cast<Real>(unit(2, 2)),
          .unit_bending = static_cast<Real>(bending_stiffness(unit)),
          .lower = lower,
          .upper = upper,
          .suspects = nullptr};
}

}  // namespace

LatticeCells::LatticeCells(const Scene& scene, const Plan& plan, const StrengthFactors& factors)
    : scene_(scene),
      plan_(without_checks(plan)),
      points_(make_points<double>(scene, plan_, factors)),
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

void LatticeCells::forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
                          kernels::NodeForces<double> upper) const {
  (void)sweep_cells_(cell_row(points_.stiffness, points_.shear, points_.row(row), points_.stride,
                              unit_stiffness_, u, shape().node(row, 0), shape().node(row + 1, 0), lower,
                              upper));
}

void LatticeCells::forces(int row, const NodeFieldOf<float>& u, kernels::NodeForces<float> lower,
                          kernels::NodeForces<float> upper) const {
  (void)sweep_corrections_(cell_row(single_.stiffness, single_.shear, points_.row(row), points_.stride,
                                    unit_stiffness_, u, shape().node(row, 0), shape().node(row + 1, 0), lower,
                                    upper));
}

/// Of the phases that are there: the largest stiffness of one against a strain along an axis over the
/// smallest one against shear.
double LatticeCells::contrast() const {
  std::array<bool, 256> is_there{};
  for (const std::uint8_t label : scene_.labels.reshaped()) is_there[label] = true;
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

Pixel LatticeCells::pixel(int row, int plane, int cell) const {
  const int k = scene_.points_per_cell;
  return {static_cast<int>(scene_.labels.rows()) - 1 - (row * k + plane / k), cell * k + plane % k};
}

const std::uint8_t* LatticeCells::label(int row, int plane, int cell) const {
  const Pixel at = pixel(row, plane, cell);
  if (at.row < 0 || at.col >= scene_.labels.cols()) return nullptr;
  const std::uint8_t& label = scene_.labels(at.row, at.col);
  return scene_.phases[label] ? &label : nullptr;
}

double LatticeCells::share_of(std::uint8_t label, std::size_t at) const {
  return (plan_.features.one_poisson_ratio ? points_.stiffness[at] : points_.shear[at]) / intact_[label];
}

CellModes LatticeCells::cell(int row, int col) const {
  CellModes sum = CellModes::Zero();
  for (int plane = 0; plane < points_.planes; ++plane)
    if (const std::uint8_t* of = label(row, plane, col))
      sum += share_of(*of, points_.at(row, plane, col)) * stiffness_.of(*of, plane);
  return sum;
}

bool LatticeCells::keep(int row, int plane, int cell, double share) {
  const std::uint8_t* of = label(row, plane, cell);
  if (of == nullptr) return false;
  const std::size_t at = points_.at(row, plane, cell);
  if (plan_.features.one_poisson_ratio) {
    points_.stiffness[at] = scene_.phases[*of]->young * share;
  } else {
    const Eigen::Matrix3d c = mpm::stiffness(*scene_.phases[*of], scene_.plane);
    points_.stiffness[at] = c(0, 1) * share;
    points_.shear[at] = c(2, 2) * share;
    single_.shear[at] = static_cast<float>(points_.shear[at]);
  }
  single_.stiffness[at] = static_cast<float>(points_.stiffness[at]);
  return true;
}

}  // namespace mpm
