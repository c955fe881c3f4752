#include "apps/bench/stability_scenes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "libmpm/solver/grid.hpp"
#include "libmpm/solver/lattice/lattice_points.hpp"

namespace app::bench {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A material point of the lattice.
struct Point {
  int row = 0, cell = 0;    ///< of its cell, row 0 at the bottom
  double xi = 0, eta = 0;   ///< place in it, in [0, 1]
  double share = 1;         ///< of its pixel [-]
  Eigen::Matrix3d elastic;  ///< stiffness [Pa]
};

std::vector<Point> points_of(const mpm::Scene& scene, const mpm::Plan& plan) {
  const int k = scene.points_per_cell;
  const auto rows = static_cast<int>(scene.labels.rows());
  const auto count = mpm::points_per_pixel(scene);
  std::vector<Point> points;
  for (int row = 0; row < rows; ++row) {
    const int up = rows - 1 - row;
    for (int col = 0; col < scene.labels.cols(); ++col)
      if (const auto& phase = scene.phases[scene.labels(row, col)])
        points.push_back({up / k, col / k, (col % k + 0.5) / k, (up % k + 0.5) / k, 1.0 / count(row, col),
                          mpm::stiffness(*phase, scene.plane)});
  }
  const mpm::ExtraPoints extra = mpm::make_extra_points(scene, plan);
  for (std::size_t row = 0; row + 1 < extra.row_begin.size(); ++row)
    for (std::size_t i = extra.row_begin[row]; i < extra.row_begin[row + 1]; ++i) {
      const mpm::CellPoint& p = extra.points[i];
      points.push_back({static_cast<int>(row), p.cell, p.xi, p.eta, p.share, p.stiffness});
    }
  return points;
}

/// Stiffness over mass of the nodes that are free to move.
class Operator {
 public:
  Operator(const mpm::Scene& scene, const mpm::Plan& plan)
      : plan_(plan),
        points_(points_of(scene, plan)),
        cols_(plan.cells_x + 1),
        per_pixel_(scene.points_per_cell) {
    const mpm::Grid grid = mpm::make_grid(scene, plan);
    const double k = scene.points_per_cell * scene.points_per_cell;
    root_ = VectorXd::Zero(2 * grid.rows * grid.cols);
    for (int row = 0; row < grid.rows; ++row)
      for (int col = 0; col < grid.cols; ++col) {
        const double w = grid.impulse_over_mass[static_cast<std::size_t>(grid.at(row, col))];
        if (w <= 0) continue;
        const double root = std::sqrt(k * w / plan.dt);  // 1 / sqrt(mass)
        const bool platen = row == 0 || row == grid.rows - 1;
        const bool rough = scene.loading.platen == mpm::Platen::rough;
        root_(2 * node(row, col)) = platen && rough ? 0 : root;
        root_(2 * node(row, col) + 1) = platen ? 0 : root;
      }
  }

  [[nodiscard]] Eigen::Index size() const { return root_.size(); }

  [[nodiscard]] VectorXd times(const VectorXd& v) const {
    const VectorXd u = root_.cwiseProduct(v);
    VectorXd f = VectorXd::Zero(size());
    for (const Point& p : points_) {
      mpm::CellDisplacement cell{};
      for (int i = 0; i < 4; ++i) {
        const Eigen::Index at = 2 * node(p.row + i / 2, p.cell + i % 2);
        cell.ux[i] = u(at);
        cell.uy[i] = u(at + 1);
      }
      const auto stress = mpm::stress_in_cell(p.elastic, cell, p.xi, p.eta, plan_.cell_size);
      const double scale = p.share * plan_.cell_size / (per_pixel_ * per_pixel_);
      const mpm::CellForces force = mpm::forces_in_cell(stress, p.xi, p.eta, scale);
      for (int i = 0; i < 4; ++i) {
        const Eigen::Index at = 2 * node(p.row + i / 2, p.cell + i % 2);
        f(at) -= force.x[i];
        f(at + 1) -= force.y[i];
      }
    }
    return root_.cwiseProduct(f);
  }

  /// Something with a part of every shape of vibration.
  [[nodiscard]] VectorXd start() const {
    VectorXd v(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      v(i) = root_(i) > 0 ? std::sin(1.0 + 1.7 * static_cast<double>(i * i % 1009)) : 0;
    return v.normalized();
  }

 private:
  [[nodiscard]] Eigen::Index node(int row, int col) const {
    return static_cast<Eigen::Index>(row) * cols_ + col;
  }

  const mpm::Plan& plan_;
  std::vector<Point> points_;
  int cols_;
  int per_pixel_;
  VectorXd root_;  ///< 1 / sqrt(mass) [sqrt(m/kg)]; 0 for what does not move
};

}  // namespace

CriticalStep critical_step(const mpm::Scene& scene, const mpm::Plan& plan) {
  const Operator a(scene, plan);
  const auto most = static_cast<int>(std::min<Eigen::Index>(300, a.size()));
  MatrixXd basis(a.size(), most);
  std::vector<double> diagonal, beside;
  VectorXd v = a.start();
  CriticalStep step;
  for (int i = 0; i < most; ++i) {
    basis.col(i) = v;
    VectorXd w = a.times(v);
    diagonal.push_back(v.dot(w));
    for (int again = 0; again < 2; ++again)
      w -= basis.leftCols(i + 1) * (basis.leftCols(i + 1).transpose() * w);
    const double rest = w.norm();
    Eigen::SelfAdjointEigenSolver<MatrixXd> small;
    small.computeFromTridiagonal(Eigen::Map<VectorXd>(diagonal.data(), i + 1),
                                 Eigen::Map<VectorXd>(beside.data(), i), Eigen::ComputeEigenvectors);
    const double square = small.eigenvalues()(i);
    step = {2 / std::sqrt(square), rest * std::abs(small.eigenvectors()(i, i)) / square};
    if (step.uncertainty < 1e-8) break;
    beside.push_back(rest);
    v = w / rest;
  }
  return step;
}

}  // namespace app::bench
