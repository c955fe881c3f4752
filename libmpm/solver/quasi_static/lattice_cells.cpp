#include "libmpm/solver/quasi_static/lattice_cells.hpp"

#include "libmpm/kernels/instruction_set.hpp"

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
      stiffness_(scene),
      sweep_cells_(chosen_kernels(scene.instruction_set).cells<double>(plan_.features)) {
  for (const auto& phase : scene.phases)
    intact_.push_back(!phase                            ? 0
                      : plan.features.one_poisson_ratio ? phase->young
                                                        : mpm::stiffness(*phase, scene.plane)(2, 2));
  Phase unit;
  unit.young = 1;
  unit.poisson = plan.poisson;
  unit_stiffness_ = mpm::stiffness(unit, scene.plane);
}

void LatticeCells::forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
                          kernels::NodeForces<double> upper) const {
  const std::size_t below = shape().node(row, 0);
  const std::size_t above = shape().node(row + 1, 0);
  const auto at = points_.row(row);
  (void)sweep_cells_({.cells = static_cast<int>(points_.stride),
                      .stride = points_.stride,
                      .ux_lower = u.x.data() + below,
                      .uy_lower = u.y.data() + below,
                      .ux_upper = u.x.data() + above,
                      .uy_upper = u.y.data() + above,
                      .stiffness = points_.stiffness.data() + at,
                      .shear = points_.shear.empty() ? nullptr : points_.shear.data() + at,
                      .tension = nullptr,
                      .crush = nullptr,
                      .cracked = nullptr,
                      .unilateral = 0,
                      .unit_axial = unit_stiffness_(0, 0),
                      .unit_lateral = unit_stiffness_(0, 1),
                      .unit_shear = unit_stiffness_(2, 2),
                      .unit_bending = bending_stiffness(unit_stiffness_),
                      .lower = lower,
                      .upper = upper,
                      .suspects = nullptr});
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

CellStiffness LatticeCells::cell(int row, int col) const {
  CellStiffness sum = CellStiffness::Zero();
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
  }
  return true;
}

}  // namespace mpm
