#include "libmpm/solver/quasi_static/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {
namespace {

constexpr int most_iterations = 2000;  ///< of one solve
constexpr double accuracy = 1e-7;      ///< of the displacements in the norm of the energy [-]

/// The plan with cells of nothing beyond the right and the upper edge, so that the grid can be halved.
Plan with_padding(Plan plan) {
  const int multiple = 1 << coarsenings(plan.cells_x, plan.cells_y);
  const auto up = [&](int cells) { return (cells + multiple - 1) / multiple * multiple; };
  plan.cells_x = up(plan.cells_x);
  plan.cells_y = up(plan.cells_y);
  plan.features.check = kernels::Check::none;  // failures are looked for where the sweeps do not
  plan.features.crack_closure = false;
  return plan;
}

/// Sums row by row, in one order for any number of threads.
double dot(const CellShape& shape, const NodeField& a, const NodeField& b) {
  double sum = 0;
  for (int row = 0; row <= shape.cells_y; ++row) {
    const std::size_t first = shape.node(row, 0);
    double lanes[8] = {0, 0, 0, 0, 0, 0, 0, 0};
    const auto n = static_cast<std::size_t>(shape.stride());
    for (std::size_t i = 0; i < n; i += 8)
      for (std::size_t lane = 0; lane < 8; ++lane)
        lanes[lane] +=
            a.x[first + i + lane] * b.x[first + i + lane] + a.y[first + i + lane] * b.y[first + i + lane];
    sum += ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7]));
  }
  return sum;
}

/// to += factor from
void add_times(NodeField& to, double factor, const NodeField& from) {
  for (std::size_t i = 0; i < to.x.size(); ++i) to.x[i] += factor * from.x[i];
  for (std::size_t i = 0; i < to.y.size(); ++i) to.y[i] += factor * from.y[i];
}

/// to = from + factor to
void times_and_add(NodeField& to, double factor, const NodeField& from) {
  for (std::size_t i = 0; i < to.x.size(); ++i) to.x[i] = from.x[i] + factor * to.x[i];
  for (std::size_t i = 0; i < to.y.size(); ++i) to.y[i] = from.y[i] + factor * to.y[i];
}

}  // namespace

Equilibrium::Equilibrium(const Scene& scene, const Plan& plan, const StrengthFactors& factors)
    : scene_(scene),
      cells_y_(plan.cells_y),
      plan_(with_padding(plan)),
      points_(make_points<double>(scene, plan_, factors)),
      stiffness_(scene) {
  sweep_cells_ = chosen_kernels(scene.instruction_set).cells<double>(plan_.features);
  for (const auto& phase : scene.phases)
    intact_.push_back(!phase                            ? 0
                      : plan.features.one_poisson_ratio ? phase->young
                                                        : mpm::stiffness(*phase, scene.plane)(2, 2));
  Phase unit;
  unit.young = 1;
  unit.poisson = plan.poisson;
  unit_stiffness_ = mpm::stiffness(unit, scene.plane);
  for (NodeField* field : {&u_, &no_load_, &residual_, &preconditioned_, &direction_, &image_})
    *field = shape().zeros();
  find_pinned_node();
  move_platens();
  make_multigrid();
}

void Equilibrium::make_multigrid() {
  const FineGrid& fine = *this;
  multigrid_ = std::make_unique<Multigrid>(
      fine, coarsenings(static_cast<int>(scene_.labels.cols()) / scene_.points_per_cell, cells_y_),
      chosen_equilibrium_kernels(scene_.instruction_set));
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
  const int cols = static_cast<int>(scene_.labels.cols()) / scene_.points_per_cell;
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
  for (int row = 0; row <= cells_y_; ++row)
    for (int col = 0; col <= plan_.cells_x; ++col)
      u_.y[shape().node(row, col)] = height * row / cells_y_;  // a first guess, exact at both platens
}

void Equilibrium::forces(int row, const NodeField& u, kernels::NodeForces<double> lower,
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

Pixel Equilibrium::pixel(int row, int plane, int cell) const {
  const int k = scene_.points_per_cell;
  return {static_cast<int>(scene_.labels.rows()) - 1 - (row * k + plane / k), cell * k + plane % k};
}

const std::uint8_t* Equilibrium::label(int row, int plane, int cell) const {
  const Pixel at = pixel(row, plane, cell);
  if (at.row < 0 || at.col >= scene_.labels.cols()) return nullptr;
  const std::uint8_t& label = scene_.labels(at.row, at.col);
  return scene_.phases[label] ? &label : nullptr;
}

double Equilibrium::share_of(std::uint8_t label, std::size_t at) const {
  return (plan_.features.one_poisson_ratio ? points_.stiffness[at] : points_.shear[at]) / intact_[label];
}

CellStiffness Equilibrium::cell(int row, int col) const {
  CellStiffness sum = CellStiffness::Zero();
  for (int plane = 0; plane < points_.planes; ++plane)
    if (const std::uint8_t* of = label(row, plane, col))
      sum += share_of(*of, points_.at(row, plane, col)) * stiffness_.of(*of, plane);
  return sum;
}

HeldNodes Equilibrium::held(int row, int col) const {
  HeldNodes held;
  const bool rough = scene_.loading.platen == Platen::rough;
  for (int node = 0; node < 4; ++node) {
    const int node_row = row + node / 2;
    if (node_row != 0 && node_row != cells_y_) continue;
    const auto i = static_cast<std::size_t>(node);
    held.y[i] = true;
    held.x[i] = rough || (node_row == 0 && col + node % 2 == pinned_);
  }
  return held;
}

void Equilibrium::clear_held(NodeField& field) const {
  for (const int row : {0, cells_y_}) {
    const auto first = static_cast<std::ptrdiff_t>(shape().node(row, 0));
    std::fill_n(field.y.begin() + first, shape().stride(), 0.0);
    if (scene_.loading.platen == Platen::rough) std::fill_n(field.x.begin() + first, shape().stride(), 0.0);
  }
  field.x[shape().node(0, pinned_)] = 0;
}

bool Equilibrium::solve(double reduction) {
  const FlushToZero flush;
  const CellShape grid = shape();
  multigrid_->residual(no_load_, u_, residual_);
  double energy = -dot(grid, u_, residual_);  // twice that of the displacements, which every iteration lowers
  clear_held(residual_);
  double goal = 0;
  double left = 0;  // about the square of the error in the norm of the energy
  for (int i = 0; i < most_iterations; ++i, ++iterations_) {
    multigrid_->precondition(residual_, preconditioned_);
    const double before = left;
    left = dot(grid, residual_, preconditioned_);
    if (i == 0) goal = reduction * reduction * left;
    if (left <= std::max(goal, accuracy * accuracy * energy)) break;
    times_and_add(direction_, i > 0 ? left / before : 0, preconditioned_);
    multigrid_->residual(no_load_, direction_, image_);  // minus the stiffness times the direction
    clear_held(image_);
    const double curvature = -dot(grid, direction_, image_);
    if (!(curvature > 0)) return false;
    add_times(u_, left / curvature, direction_);
    add_times(residual_, left / curvature, image_);
    energy -= left * left / curvature;
  }
  read_reactions();
  return left <= std::max(goal, accuracy * accuracy * energy);
}

void Equilibrium::read_reactions() {
  multigrid_->residual(no_load_, u_, image_);
  const auto sum = [&](int row) {
    double force = 0;
    for (int col = 0; col <= plan_.cells_x; ++col) force += image_.y[shape().node(row, col)];
    return force / (points_.planes * scene_.width());
  };
  modulus_top_ = -sum(cells_y_);
  modulus_bottom_ = sum(0);
}

void Equilibrium::change(const std::vector<Change>& changes) {
  std::vector<Multigrid::Cell> cells;
  for (const Change& one : changes) {
    const std::uint8_t* of = label(one.row, one.plane, one.cell);
    if (of == nullptr) continue;
    const std::size_t at = points_.at(one.row, one.plane, one.cell);
    if (plan_.features.one_poisson_ratio) {
      points_.stiffness[at] = scene_.phases[*of]->young * one.kept;
    } else {
      const Eigen::Matrix3d c = mpm::stiffness(*scene_.phases[*of], scene_.plane);
      points_.stiffness[at] = c(0, 1) * one.kept;
      points_.shear[at] = c(2, 2) * one.kept;
    }
    cells.push_back({one.row, one.cell});
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
