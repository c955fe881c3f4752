#include "libmpm/solver/quasi_static/coarse_cell.hpp"

#include <algorithm>

namespace mpm {
namespace {

CellModes of_point(const Phase& phase, const Scene& scene, int plane) {
  const int k = scene.points_per_cell;
  const Eigen::Matrix3d c = stiffness(phase, scene.plane);
  CellStiffness matrix = point_stiffness(c, (plane % k + 0.5) / k, (plane / k + 0.5) / k);
  if (scene.pixel_cells) matrix += bending_matrix(c);
  return by_modes(matrix, 1);
}

ChildWeights without(ChildWeights weights, const std::array<bool, 4>& held) {
  for (int node = 0; node < 4; ++node)
    if (held[static_cast<std::size_t>(node)]) weights.row(node).setZero();
  return weights;
}

using Modes = Eigen::Matrix<double, 5, 8>;

/// Modes over the displacements of the nodes.
Modes modes_of(double slant) {
  const Eigen::RowVector4d along_x(-1, 1, -1, 1);
  const Eigen::RowVector4d along_y(-1, -1, 1, 1);
  const Eigen::RowVector4d between(1, -1, -1, 1);
  Modes modes = Modes::Zero();
  modes.block<1, 4>(0, 0) = along_x;
  modes.block<1, 4>(1, 4) = along_y;
  modes.block<1, 4>(2, 0) = along_y;
  modes.block<1, 4>(2, 4) = slant * along_x;
  modes.block<1, 4>(3, 0) = modes.block<1, 4>(4, 4) = between;
  return modes;
}

/// Displacements of the nodes (columns) in which one mode is 1 and the others are 0.
Modes shapes_of(double slant) {
  Modes shapes = modes_of(slant);
  for (int i = 0; i < 5; ++i) shapes.row(i) /= shapes.row(i).squaredNorm();
  return shapes;
}

}  // namespace

CellModes by_modes(const CellStiffness& cell, double slant) {
  const Modes shapes = shapes_of(slant);
  return shapes * cell * shapes.transpose();
}

CellStiffness by_nodes(const CellModes& cell, double slant) {
  const Modes modes = modes_of(slant);
  return modes.transpose() * cell * modes;
}

NodeStiffness at_corner(const CellModes& cell, double slant, int corner) {
  const double x = corner % 2 == 0 ? -1 : 1;
  const double y = corner / 2 == 0 ? -1 : 1;
  const int of_x[3] = {0, 2, 3};
  const int of_y[3] = {1, 2, 4};
  const double ux[3] = {x, y, x * y};
  const double uy[3] = {y, slant * x, x * y};
  NodeStiffness sum;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      sum.xx += ux[i] * cell(of_x[i], of_x[j]) * ux[j];
      sum.xy += ux[i] * cell(of_x[i], of_y[j]) * uy[j];
      sum.yy += uy[i] * cell(of_y[i], of_y[j]) * uy[j];
    }
  return sum;
}

NodeStiffness at_corner(const CellStiffness& cell, int corner) {
  return {cell(corner, corner), cell(corner, corner + 4), cell(corner + 4, corner + 4)};
}

void add_child(CellModes& coarse, const CellModes& fine, const CellModes& modes) {
  coarse += modes.transpose() * (fine * modes);
}

CellModes child_modes(const ChildWeights& weights, double child_slant, double slant) {
  CellStiffness both = CellStiffness::Zero();
  both.topLeftCorner<4, 4>() = both.bottomRightCorner<4, 4>() = weights;
  return modes_of(child_slant) * both * shapes_of(slant).transpose();
}

PointStiffness::PointStiffness(const Scene& scene)
    : planes_(scene.points_per_cell * scene.points_per_cell),
      matrices_(scene.phases.size() * static_cast<std::size_t>(planes_), CellModes::Zero()) {
  for (std::size_t label = 0; label < scene.phases.size(); ++label)
    for (int plane = 0; plane < planes_ && scene.phases[label]; ++plane)
      matrices_[label * static_cast<std::size_t>(planes_) + static_cast<std::size_t>(plane)] =
          of_point(*scene.phases[label], scene, plane);
}

bool HeldNodes::any() const {
  const auto yes = [](bool held) { return held; };
  return std::any_of(x.begin(), x.end(), yes) || std::any_of(y.begin(), y.end(), yes);
}

ChildWeights child_weights(const std::array<double, 2>& x, const std::array<double, 2>& y) {
  ChildWeights weights;
  for (std::size_t node = 0; node < 4; ++node) {
    const double right = x[node % 2];
    const double up = y[node / 2];
    weights.row(static_cast<Eigen::Index>(node)) << (1 - right) * (1 - up), right * (1 - up),
        (1 - right) * up, right * up;
  }
  return weights;
}

void add_child(CellStiffness& coarse, const CellStiffness& fine, const ChildWeights& whole,
               const HeldNodes& held) {
  const bool any = held.any();
  const ChildWeights px = any ? without(whole, held.x) : whole;
  const ChildWeights py = any ? without(whole, held.y) : whole;
  coarse.topLeftCorner<4, 4>() += px.transpose() * (fine.topLeftCorner<4, 4>() * px);
  const Eigen::Matrix4d mixed = px.transpose() * (fine.topRightCorner<4, 4>() * py);
  coarse.topRightCorner<4, 4>() += mixed;
  coarse.bottomLeftCorner<4, 4>() += mixed.transpose();
  coarse.bottomRightCorner<4, 4>() += py.transpose() * (fine.bottomRightCorner<4, 4>() * py);
}

}  // namespace mpm
