/// Stiffness of the cells of a scene, and of four cells seen as one of twice the size.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/lattice/cell_stiffness.hpp"

namespace mpm {

/// Stiffness of a cell against its five modes. Of the differences between neighbouring nodes, each summed
/// over both edges: u_x along x, u_y along y, u_x along y plus `slant` times u_y along x; and the difference
/// between both edges of u_x along x, of u_y along x. What moves without a strain needs no entry, and costs
/// no digits. slant: height of the cell over its width.
using CellModes = Eigen::Matrix<double, 5, 5>;

/// The same cell by modes and by nodes. Only a cell that resists nothing but strain has modes.
[[nodiscard]] CellModes by_modes(const CellStiffness& cell, double slant);
[[nodiscard]] CellStiffness by_nodes(const CellModes& cell, double slant);

/// Stiffness of a node.
struct NodeStiffness {
  double xx = 0, xy = 0, yy = 0;
};
/// What a cell gives to one of its nodes.   @param corner  in the order of CellStiffness.
[[nodiscard]] NodeStiffness at_corner(const CellModes& cell, double slant, int corner);
[[nodiscard]] NodeStiffness at_corner(const CellStiffness& cell, int corner);

/// Stiffness that a point of each phase adds to its cell, by its place in the cell; in the scale of the
/// sweeps, so that the points of a cell count K x K times.
class PointStiffness {
 public:
  /// The scene must outlive this.
  explicit PointStiffness(const Scene& scene);

  /// @param plane  place of the point in its cell, see LatticePoints.   @pre the label is that of a phase.
  [[nodiscard]] const CellModes& of(std::uint8_t label, int plane) const {
    return matrices_[label * static_cast<std::size_t>(planes_) + static_cast<std::size_t>(plane)];
  }

 private:
  int planes_;
  std::vector<CellModes> matrices_;  ///< zero for labels without a phase
};

/// Whether each of the four nodes of a cell is held in x and in y.
struct HeldNodes {
  std::array<bool, 4> x{}, y{};
  [[nodiscard]] bool any() const;
};

/// Weights of the nodes of a coarse cell (columns) in those of one of its children (rows) [-].
using ChildWeights = Eigen::Matrix4d;
/// Bilinear ones, from those of the right coarse node at both ends of the child along x, and of the upper one
/// along y.
[[nodiscard]] ChildWeights child_weights(const std::array<double, 2>& x, const std::array<double, 2>& y);

/// Adds the stiffness of a child of a coarse cell: P^T K P with interpolation P, without the rows of held
/// nodes.
void add_child(CellStiffness& coarse, const CellStiffness& fine, const ChildWeights& whole,
               const HeldNodes& held);

/// The same where no node is held.   @param modes  those of the child over those of the coarse cell.
void add_child(CellModes& coarse, const CellModes& fine, const CellModes& modes);
/// Those modes, from the weights; slants of the child and of the coarse cell.
[[nodiscard]] CellModes child_modes(const ChildWeights& weights, double child_slant, double slant);

}  // namespace mpm
