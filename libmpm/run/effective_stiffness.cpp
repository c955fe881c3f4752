#include "libmpm/run/effective_stiffness.hpp"

#include <Eigen/LU>
#include <cmath>
#include <utility>
#include <vector>

#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/material/stiffness_bounds.hpp"
#include "libmpm/solver/quasi_static/conjugate_gradients.hpp"
#include "libmpm/solver/quasi_static/lattice_cells.hpp"

namespace mpm {
namespace {

constexpr double exactness = 1e-6;  ///< of the displacements in the norm of the energy [-]
constexpr int loadings = 3;         ///< xx, yy, xy: columns of the tensor

/// A uniform strain or stress in the plane.
using Uniform = Eigen::Matrix2d;
Uniform unit_strain(int loading) {
  Uniform strain = Uniform::Zero();
  if (loading < 2)
    strain(loading, loading) = 1;
  else
    strain(0, 1) = strain(1, 0) = 0.5;
  return strain;
}
Uniform unit_stress(int loading) { return loading < 2 ? unit_strain(loading) : 2 * unit_strain(loading); }

/// The specimen as a grid, held, loaded or wrapped at its edges.
class Specimen final : public LatticeCells {
 public:
  Specimen(const Scene& scene, const Plan& plan, Boundary boundary)
      : LatticeCells(scene, plan, StrengthFactors(scene, false)), boundary_(boundary) {}

  [[nodiscard]] EdgeNodes edges() const override {
    return boundary_ == Boundary::periodic         ? EdgeNodes::wrapped
           : boundary_ == Boundary::uniform_stress ? EdgeNodes::free
                                                   : EdgeNodes::held;
  }
  [[nodiscard]] HeldNodes held(int row, int col) const override;

  /// Adds u = strain x.
  void add_uniform(const Uniform& strain, NodeField& u) const;
  /// Forces of the tractions of a uniform stress.
  [[nodiscard]] NodeField tractions(const Uniform& stress) const;
  /// Whether every piece is in balance under forces at its edge.
  [[nodiscard]] bool in_balance(const NodeField& load) const;
  /// Whether no void lies along the sides that these tractions pull at.
  [[nodiscard]] bool feels(const Uniform& stress) const;

  /// Product of force and displacement over the energy density [m^2].
  [[nodiscard]] double area() const { return points_.planes * scene_.width() * scene_.height(); }

 private:
  struct Side {
    int axis, direction;  ///< of its normal
  };
  static constexpr Side sides[] = {{0, -1}, {0, 1}, {1, -1}, {1, 1}};

  /// Calls visit(row, col) for the cells along a side.
  template <class Visit>
  void along(const Side& side, const Visit& visit) const;
  [[nodiscard]] bool has_void(const Side& side) const;
  [[nodiscard]] bool is_solid(int row, int col) const;
  [[nodiscard]] bool is_at_edge(int row, int col) const {
    return row == 0 || col == 0 || row == plan_.cells_y || col == plan_.cells_x;
  }

  Boundary boundary_;
};

HeldNodes Specimen::held(int row, int col) const {
  HeldNodes held;
  if (boundary_ == Boundary::uniform_strain)
    for (int node = 0; node < 4; ++node)
      held.x[static_cast<std::size_t>(node)] = held.y[static_cast<std::size_t>(node)] =
          is_at_edge(row + node / 2, col + node % 2);
  return held;
}

void Specimen::add_uniform(const Uniform& strain, NodeField& u) const {
  const CellShape grid = shape();
  for (int row = 0; row <= grid.cells_y; ++row)
    for (int col = 0; col <= grid.cells_x; ++col) {
      const Eigen::Vector2d moved = plan_.cell_size * (strain * Eigen::Vector2d(col, row));
      u.x[grid.node(row, col)] += moved.x();
      u.y[grid.node(row, col)] += moved.y();
    }
}

template <class Visit>
void Specimen::along(const Side& side, const Visit& visit) const {
  const int length = side.axis == 0 ? plan_.cells_y : plan_.cells_x;
  const int depth = side.axis == 0 ? plan_.cells_x : plan_.cells_y;
  const int across = side.direction > 0 ? depth - 1 : 0;
  for (int i = 0; i < length; ++i) side.axis == 0 ? visit(i, across) : visit(across, i);
}

NodeField Specimen::tractions(const Uniform& stress) const {
  const CellShape grid = shape();
  NodeField load = grid.zeros();
  for (const Side& side : sides) {
    const Eigen::Vector2d half =
        0.5 * side.direction * plan_.cell_size * points_.planes * stress.col(side.axis);
    const int beyond = side.direction > 0 ? 1 : 0;
    along(side, [&](int row, int col) {
      for (int end = 0; end < 2; ++end) {
        const std::size_t at =
            side.axis == 0 ? grid.node(row + end, col + beyond) : grid.node(row + beyond, col + end);
        load.x[at] += half.x();
        load.y[at] += half.y();
      }
    });
  }
  return load;
}

bool Specimen::is_solid(int row, int col) const {
  for (int plane = 0; plane < points_.planes; ++plane)
    if (label({row, plane, col}) != nullptr) return true;
  return false;
}

bool Specimen::has_void(const Side& side) const {
  const int k = scene_.points_per_cell;
  bool found = false;
  along(side, [&](int row, int col) {
    for (int i = 0; i < k; ++i) {
      const int depth = side.direction > 0 ? k - 1 : 0;
      found |= label({row, side.axis == 0 ? i * k + depth : depth * k + i, col}) == nullptr;
    }
  });
  return found;
}

bool Specimen::feels(const Uniform& stress) const {
  for (const Side& side : sides)
    if (stress.col(side.axis).norm() > 0 && has_void(side)) return false;
  return true;
}

/// Pieces are of cells that share a node.
bool Specimen::in_balance(const NodeField& load) const {
  const CellShape grid = shape();
  std::vector<char> open(grid.nodes(), 1);
  std::vector<std::pair<int, int>> todo;
  const auto reach_cell = [&](int row, int col) {
    if (row < 0 || col < 0 || row >= grid.cells_y || col >= grid.cells_x || !is_solid(row, col)) return;
    for (int node = 0; node < 4; ++node) {
      const std::pair<int, int> place{row + node / 2, col + node % 2};
      char& is_open = open[grid.node(place.first, place.second)];
      if (is_open != 0) todo.push_back(place);
      is_open = 0;
    }
  };
  for (int first_row = 0; first_row < grid.cells_y; ++first_row)
    for (int first_col = 0; first_col < grid.cells_x; ++first_col) {
      if (open[grid.node(first_row, first_col)] == 0) continue;
      reach_cell(first_row, first_col);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // forces and moment
      double all = 0;
      while (!todo.empty()) {
        const auto [row, col] = todo.back();
        todo.pop_back();
        const std::size_t at = grid.node(row, col);
        sum += Eigen::Vector3d(load.x[at], load.y[at],
                               (col * load.y[at] - row * load.x[at]) / (grid.cells_x + grid.cells_y));
        all += std::abs(load.x[at]) + std::abs(load.y[at]);
        for (int cell = 0; cell < 4; ++cell) reach_cell(row - cell / 2, col - cell % 2);
      }
      if (sum.norm() > 1e-9 * all) return false;
    }
  return true;
}

/// The displacements of each loading, and what the cells do with them.
struct Solved {
  NodeField u, forces;  ///< forces: stiffness times u
};

class Homogenisation {
 public:
  Homogenisation(const Scene& scene, Boundary boundary)
      : scene_(scene),
        specimen_(scene, plan(scene), boundary),
        multigrid_(specimen_, coarsenings(specimen_.shape().cells_x, specimen_.shape().cells_y),
                   chosen_equilibrium_kernels(scene.instruction_set)),
        gradients_(specimen_, multigrid_) {}

  EffectiveStiffness under_strain();
  EffectiveStiffness under_stress();

 private:
  Solved solve(NodeField u, const NodeField* load);
  [[nodiscard]] double density(const NodeField& a, const NodeField& b) const {
    return dot(specimen_.shape(), a, b) / specimen_.area();
  }
  EffectiveStiffness with_tallies(EffectiveStiffness found) const {
    found.iterations = gradients_.iterations();
    found.solved = solved_;
    return found;
  }

  const Scene& scene_;
  Specimen specimen_;
  Multigrid multigrid_;
  ConjugateGradients gradients_;
  bool solved_ = true;
};

Solved Homogenisation::solve(NodeField u, const NodeField* load) {
  solved_ &= gradients_.solve(u, {.accuracy = exactness}, load);
  NodeField forces = gradients_.unbalanced(u);
  for (AlignedVector<double>* values : {&forces.x, &forces.y})
    for (double& value : *values) value = -value;
  return {std::move(u), std::move(forces)};
}

/// Twice the energies, whose error is of the order of that of the displacements squared.
EffectiveStiffness Homogenisation::under_strain() {
  std::vector<NodeField> uniform;
  std::vector<Solved> solved;
  for (int i = 0; i < loadings; ++i) {
    uniform.push_back(specimen_.shape().zeros());
    specimen_.add_uniform(unit_strain(i), uniform.back());
    solved.push_back(solve(uniform.back(), nullptr));
  }
  Eigen::Matrix3d energy;
  Eigen::Matrix3d stress;  // mean
  for (int i = 0; i < loadings; ++i)
    for (int j = 0; j < loadings; ++j) {
      const auto& [u, forces] = solved[static_cast<std::size_t>(j)];
      energy(i, j) = density(solved[static_cast<std::size_t>(i)].u, forces);
      stress(i, j) = density(uniform[static_cast<std::size_t>(i)], forces);
    }
  EffectiveStiffness found;
  found.stiffness = 0.5 * (energy + energy.transpose());
  found.energy_error = (stress - energy).cwiseAbs().maxCoeff() / found.stiffness.cwiseAbs().maxCoeff();
  return with_tallies(found);
}

EffectiveStiffness Homogenisation::under_stress() {
  const Eigen::Matrix3d guess = stiffness(stiffness_bounds(phase_shares(scene_)).voigt).inverse();
  EffectiveStiffness found;
  std::vector<int> carried;
  std::vector<NodeField> loads;
  std::vector<Solved> solved;
  for (int i = 0; i < loadings; ++i) {
    NodeField load = specimen_.tractions(unit_stress(i));
    const bool possible = specimen_.feels(unit_stress(i)) && specimen_.in_balance(load);
    found.carried[static_cast<std::size_t>(i)] = possible;
    if (!possible) continue;
    NodeField u = specimen_.shape().zeros();
    for (int k = 0; k < loadings; ++k) specimen_.add_uniform(guess(k, i) * unit_strain(k), u);
    carried.push_back(i);
    solved.push_back(solve(std::move(u), &load));
    loads.push_back(std::move(load));
  }
  const auto n = static_cast<Eigen::Index>(carried.size());
  Eigen::MatrixXd energy(n, n);
  Eigen::MatrixXd strain(n, n);  // mean
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto& [u, forces] = solved[static_cast<std::size_t>(j)];
      energy(i, j) = density(solved[static_cast<std::size_t>(i)].u, forces);
      strain(i, j) = density(loads[static_cast<std::size_t>(i)], u);
    }
  found.stiffness.setZero();
  if (n > 0) {
    const Eigen::MatrixXd compliance = strain + strain.transpose() - 0.5 * (energy + energy.transpose());
    const Eigen::MatrixXd stiffness = compliance.inverse();
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        found.stiffness(carried[static_cast<std::size_t>(i)], carried[static_cast<std::size_t>(j)]) =
            0.5 * (stiffness(i, j) + stiffness(j, i));
    found.energy_error = (strain - energy).cwiseAbs().maxCoeff() / compliance.cwiseAbs().maxCoeff();
  }
  return with_tallies(found);
}

}  // namespace

EffectiveStiffness effective_stiffness(const Scene& scene, Boundary boundary) {
  Homogenisation homogenisation(scene, boundary);
  return boundary == Boundary::uniform_stress ? homogenisation.under_stress() : homogenisation.under_strain();
}

}  // namespace mpm
