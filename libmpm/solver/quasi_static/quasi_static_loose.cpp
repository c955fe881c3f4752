// What has come loose from the platens carries nothing, and would only be in the way of the iteration.
#include <algorithm>

#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

namespace mpm {
namespace {

constexpr int steps_between = 16;  ///< two looks for loose pieces; one costs as much as an iteration
constexpr std::int64_t many_iterations = 30;  ///< of a solve from the last state; usual are about 5

}  // namespace

/// Whether a point holds its cell together, by the share of its stiffness that it has.
bool QuasiStaticSolver::is_live(double share) const {
  return share > (scene_.damage.residual_stiffness > 0 ? 0 : 1.5 * least_kept());
}

/// What is left of the specimen may hang on failed points only.
bool QuasiStaticSolver::may_be_loose(std::int64_t iterations) const {
  if (scene_.damage.residual_stiffness > 0) return false;
  double stiffest = 0;
  for (const Limits& limits : limits_) stiffest = std::max(stiffest, limits.stiffness(0, 0));
  const double of_failed_row = least_kept() * stiffest * plan_.cells_y;  // no row of failed points is stiffer
  return iterations > many_iterations || steps_ % steps_between == 0 ||
         equilibrium_.modulus() < 10 * of_failed_row;
}

void QuasiStaticSolver::take_out_loose() {
  if (parted_) return;
  const auto cells_x = static_cast<std::size_t>(plan_.cells_x);
  std::vector<char> holds(cells_x * static_cast<std::size_t>(plan_.cells_y));
  each_point([&](const Place& at, std::size_t) {
    if (is_live(equilibrium_.kept(at)))
      holds[static_cast<std::size_t>(at.row) * cells_x + static_cast<std::size_t>(at.cell)] = 1;
  });
  const Pieces pieces(
      plan_.cells_x, plan_.cells_y,
      [&](int row, int cell) {
        return holds[static_cast<std::size_t>(row) * cells_x + static_cast<std::size_t>(cell)] != 0;
      },
      plan_.boundary);
  take_out(pieces);
  parted_ = !pieces.joins_platens();
  if (parted_) equilibrium_.part(pieces);
}

/// The points of cells with nodes that no platen holds lose their stiffness, failed ones too, which held the
/// others.
void QuasiStaticSolver::take_out(const Pieces& pieces) {
  std::vector<Equilibrium::Change> changes;
  const std::int64_t before = carrying_;
  each_point([&](const Place& at, std::size_t index) {
    if (pieces.is_held(at.row, at.cell)) return;
    const double share = equilibrium_.kept(at);
    if (share <= 0) return;
    if (is_live(share)) --carrying_;
    factors_[index] = 0;
    set_resistance(at, index);
    changes.push_back({at, 0, 0});
  });
  if (carrying_ == before) return;  // a crack is wider than a cell, and holds nothing
  equilibrium_.change(changes);     // nodes without stiffness stay where they are
}

}  // namespace mpm
