#include "libmpm/solver/quasi_static/equilibrium.hpp"

#include <algorithm>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {
namespace {

constexpr double accuracy = 1e-7;  ///< of the displacements in the norm of the energy [-]

}  // namespace

Equilibrium::Equilibrium(const Scene& scene, const Plan& plan, const StrengthFactors& factors)
    : LatticeCells(scene, plan, factors), u_(shape().zeros()) {
  find_pinned_node();
  move_platens();
  make_multigrid();
}

void Equilibrium::make_multigrid() {
  const FineGrid& fine = *this;
  multigrid_ = std::make_unique<Multigrid>(fine, coarsenings(plan_.cells_x, plan_.cells_y),
                                           chosen_equilibrium_kernels(scene_.instruction_set), plan_.threads);
  gradients_ = std::make_unique<ConjugateGradients>(fine, *multigrid_);
}

bool Equilibrium::restore(const AlignedVector<double>& stiffness, const AlignedVector<double>& shear) {
  const auto possible = [](const AlignedVector<double>& now, const AlignedVector<double>& intact) {
    return std::equal(now.begin(), now.end(), intact.begin(), intact.end(),
                      [](double a, double b) { return a >= 0 && a <= b; });
  };
  if (!possible(stiffness, points_.stiffness) || !possible(shear, points_.shear)) return false;
  take_over(stiffness, shear);
  make_multigrid();
  return true;
}

/// The node nearest the middle of the lower edge that touches a point.
void Equilibrium::find_pinned_node() {
  const int cols = plan_.cells_x;
  const auto is_solid = [&](int col) {
    for (int cell = std::max(0, col - 1); cell <= std::min(cols - 1, col); ++cell)
      for (int plane = 0; plane < points_.planes; ++plane)
        if (points_.stiffness[points_.at(0, plane, cell)] > 0) return true;
    return false;
  };
  pinned_ = nearest_to_middle(cols + 1, is_solid);
}

void Equilibrium::move_platens() {
  const double height = scene_.height();
  for (int row = 0; row <= plan_.cells_y; ++row)
    for (int col = 0; col <= plan_.cells_x; ++col)
      u_.y[shape().node(row, col)] = height * row / plan_.cells_y;  // a first guess, exact at both platens
}

HeldNodes Equilibrium::held(int row, int col) const {
  HeldNodes held;
  const bool rough = scene_.loading.platen == Platen::rough;
  for (int node = 0; node < 4; ++node) {
    const int node_row = row + node / 2;
    if (node_row != 0 && node_row != plan_.cells_y) continue;
    const auto i = static_cast<std::size_t>(node);
    held.y[i] = true;
    held.x[i] = rough || (node_row == 0 && col + node % 2 == pinned_);
  }
  return held;
}

bool Equilibrium::solve(double reduction) {
  const bool solved = gradients_->solve(u_, reduction, accuracy);
  read_reactions();
  return solved;
}

void Equilibrium::read_reactions() {
  const double area = points_.planes * scene_.width();
  modulus_top_ = -gradients_->force_y(plan_.cells_y) / area;
  modulus_bottom_ = gradients_->force_y(0) / area;
}

void Equilibrium::change(const std::vector<Change>& changes) {
  std::vector<Multigrid::Cell> cells;
  for (const Change& one : changes) {
    if (keep(one.row, one.plane, one.cell, one.kept)) cells.push_back({one.row, one.cell});
  }
  multigrid_->update(std::move(cells));
}

double Equilibrium::largest_utilisation(int row, int plane, const Resistance& resistance, double sign) const {
  const std::size_t at = points_.at(row, plane, 0);
  const std::size_t below = shape().node(row, 0);
  const std::size_t above = shape().node(row + 1, 0);
  const int k = scene_.points_per_cell;
  const Eigen::Matrix3d& unit = unit_stiffness();
  return multigrid_->kernels().largest_utilisation(
      {.cells = static_cast<int>(points_.stride),
       .ux_lower = u_.x.data() + below,
       .uy_lower = u_.y.data() + below,
       .ux_upper = u_.x.data() + above,
       .uy_upper = u_.y.data() + above,
       .xi = (plane % k + 0.5) / k,
       .eta = (plane / k + 0.5) / k,
       .scale = sign / plan_.cell_size,
       .stiffness = points_.stiffness.data() + at,
       .shear = points_.shear.empty() ? nullptr : points_.shear.data() + at,
       .unit_axial = unit(0, 0),
       .unit_lateral = unit(0, 1),
       .unit_shear = unit(2, 2),
       .tension = resistance.tension.data() + at,
       .crush = resistance.crush.data() + at,
       .crush_share = resistance.crush_share});
}

void Equilibrium::part(const Pieces& pieces) {
  for (int row = 0; row <= plan_.cells_y; ++row)
    for (int col = 0; col <= plan_.cells_x; ++col) {
      const std::size_t node = shape().node(row, col);
      if (!pieces.is_above(row, col) && !pieces.is_below(row, col)) continue;
      u_.x[node] = 0;
      u_.y[node] = pieces.is_above(row, col) ? scene_.height() : 0;
    }
  modulus_top_ = modulus_bottom_ = 0;
}

CellDisplacement Equilibrium::displacement(int row, int cell) const {
  const std::size_t lower = shape().node(row, cell);
  const std::size_t upper = shape().node(row + 1, cell);
  return {{u_.x[lower], u_.x[lower + 1], u_.x[upper], u_.x[upper + 1]},
          {u_.y[lower], u_.y[lower + 1], u_.y[upper], u_.y[upper + 1]}};
}

}  // namespace mpm
