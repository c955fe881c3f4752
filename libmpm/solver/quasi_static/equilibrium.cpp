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
                                           chosen_equilibrium_kernels(scene_.instruction_set));
  gradients_ = std::make_unique<ConjugateGradients>(fine, *multigrid_);
}

bool Equilibrium::restore(const AlignedVector<double>& stiffness, const AlignedVector<double>& shear) {
  const auto possible = [](const AlignedVector<double>& now, const AlignedVector<double>& intact) {
    return std::equal(now.begin(), now.end(), intact.begin(), intact.end(),
                      [](double a, double b) { return a >= 0 && a <= b; });
  };
  if (!possible(stiffness, points_.stiffness) || !possible(shear, points_.shear)) return false;
  points_.stiffness = stiffness;
  points_.shear = shear;
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

void Equilibrium::clear_held(NodeField& field) const {
  for (const int row : {0, plan_.cells_y}) {
    const auto first = static_cast<std::ptrdiff_t>(shape().node(row, 0));
    std::fill_n(field.y.begin() + first, shape().stride(), 0.0);
    if (scene_.loading.platen == Platen::rough) std::fill_n(field.x.begin() + first, shape().stride(), 0.0);
  }
  field.x[shape().node(0, pinned_)] = 0;
}

bool Equilibrium::solve(double reduction) {
  const bool solved = gradients_->solve(u_, reduction, accuracy);
  read_reactions();
  return solved;
}

void Equilibrium::read_reactions() {
  const NodeField& reactions = gradients_->unbalanced(u_);
  const auto sum = [&](int row) {
    double force = 0;
    for (int col = 0; col <= plan_.cells_x; ++col) force += reactions.y[shape().node(row, col)];
    return force / (points_.planes * scene_.width());
  };
  modulus_top_ = -sum(plan_.cells_y);
  modulus_bottom_ = sum(0);
}

void Equilibrium::change(const std::vector<Change>& changes) {
  std::vector<Multigrid::Cell> cells;
  for (const Change& one : changes) {
    if (keep(one.row, one.plane, one.cell, one.kept)) cells.push_back({one.row, one.cell});
  }
  multigrid_->update(std::move(cells));
}

CellDisplacement Equilibrium::displacement(int row, int cell) const {
  const std::size_t lower = shape().node(row, cell);
  const std::size_t upper = shape().node(row + 1, cell);
  return {{u_.x[lower], u_.x[lower + 1], u_.x[upper], u_.x[upper + 1]},
          {u_.y[lower], u_.y[lower + 1], u_.y[upper], u_.y[upper + 1]}};
}

}  // namespace mpm
