/// The finite element mesh of a mask: one square of four nodes a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "specimen/body/mask.hpp"

namespace exchange {

/// An edge of the specimen.
enum class Edge { bottom, right, top, left };
inline constexpr std::array edges{Edge::bottom, Edge::right, Edge::top, Edge::left};
[[nodiscard]] const char* name_of(Edge edge);  ///< "BOTTOM" and so on

/// A phase of which there is a pixel.
struct MeshPhase {
  std::uint8_t label = 0;
  std::string name;
  std::int64_t elements = 0;
};

/// A node where grid lines meet: `line` counts from 0 at the top, `col` from 0 at the left.
struct MeshNode {
  int line = 0;
  int col = 0;
};

/// Numbers 1, 2, 3, ... for those places of a long row that are taken; an eighth of a byte a place and more.
class DenseNumbers {
 public:
  void add(bool taken);  ///< the next place
  /// @param place  that is taken, from 0.
  [[nodiscard]] std::int64_t of(std::int64_t place) const;
  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  std::vector<std::uint64_t> taken_;  ///< a bit a place
  std::vector<std::int64_t> before_;  ///< how many are taken before each 64 of them
  std::int64_t places_ = 0;
  std::int64_t count_ = 0;
};

/// Every pixel that is not void is an element, and neighbours share their nodes. Both are numbered 1, 2, 3,
/// ... row by row from the top left, and what is void, or a node amid void, is not counted: CalculiX takes
/// memory for every number up to the largest one, be there an element or not.
class PixelMesh {
 public:
  /// @param mask  must outlive the mesh.   @throws specimen::Error when all of it is void.
  explicit PixelMesh(const specimen::LabelledMask& mask);

  [[nodiscard]] int rows() const { return mask_.labels.rows; }
  [[nodiscard]] int cols() const { return mask_.labels.cols; }
  [[nodiscard]] const specimen::LabelledMask& mask() const { return mask_; }
  [[nodiscard]] const std::vector<MeshPhase>& phases() const { return phases_; }
  [[nodiscard]] std::int64_t nodes() const { return nodes_.count(); }
  [[nodiscard]] std::int64_t elements() const { return elements_.count(); }

  /// True when the node is a corner of an element.
  [[nodiscard]] bool has(MeshNode node) const;
  /// Of a node that is there.
  [[nodiscard]] std::int64_t number(MeshNode node) const {
    return nodes_.of(std::int64_t{node.line} * (cols() + 1) + node.col);
  }
  /// Number of a pixel that is not void.
  [[nodiscard]] std::int64_t element(int row, int col) const {
    return elements_.of(std::int64_t{row} * cols() + col);
  }
  /// Numbers of the corners of a pixel, counter-clockwise from the bottom left one.
  [[nodiscard]] std::array<std::int64_t, 4> corners(int row, int col) const;

  void for_each_node(const std::function<void(MeshNode)>& visit) const;
  void for_each_element(const MeshPhase& phase, const std::function<void(int row, int col)>& visit) const;

  /// Sides of elements along an edge, counter-clockwise round the specimen: numbers of their two nodes.
  [[nodiscard]] std::vector<std::array<std::int64_t, 2>> sides(Edge edge) const;
  /// Numbers of the nodes on an edge, in the same order.
  [[nodiscard]] std::vector<std::int64_t> nodes_on(Edge edge) const;

  /// Coordinates [m] of the grid lines as text: of columns from the left, of rows from the top.
  [[nodiscard]] std::vector<std::string> x_texts() const;
  [[nodiscard]] std::vector<std::string> y_texts() const;

 private:
  [[nodiscard]] bool solid(int row, int col) const {
    return mask_.labels.contains(row, col) && mask_.labels(row, col) != specimen::phase::void_;
  }

  const specimen::LabelledMask& mask_;
  std::vector<MeshPhase> phases_;
  DenseNumbers elements_;
  DenseNumbers nodes_;
};

}  // namespace exchange
