#include "libmpm/solver/quasi_static/coarse_cell.hpp"

#include <algorithm>

namespace mpm {
namespace {

CellStiffness of_point(const Phase& phase, const Scene& scene, int plane) {
  const int k = scene.points_per_cell;
  const Eigen::Matrix3d c = stiffness(phase, scene.plane);
  CellStiffness matrix = point_stiffness(c, (plane % k + 0.5) / k, (plane / k + 0.5) / k);
  if (scene.pixel_cells) matrix += bending_matrix(c);
  return matrix;
}

ChildWeights without(ChildWeights weights, const std::array<bool, 4>& held) {
  for (int node = 0; node < 4; ++node)
    if (held[static_cast<std::size_t>(node)]) weights.row(node).setZero();
  return weights;
}

}  // namespace

PointStiffness::PointStiffness(const Scene& scene)
    : planes_(scene.points_per_cell * scene.points_per_cell),
      matrices_(scene.phases.size() * static_cast<std::size_t>(planes_), CellStiffness::Zero()) {
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
