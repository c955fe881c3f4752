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

/// Every pixel that is not void is an element, and neighbours share their nodes. Numbers tell the place:
/// pixel (row, col) is element row * cols + col + 1, and the node at its top left corner is number row *
/// (cols + 1) + col + 1. So numbers of void pixels, and of nodes amid void, are missing.
class PixelMesh {
 public:
  /// @param mask  must outlive the mesh.   @throws specimen::Error when all of it is void.
  explicit PixelMesh(const specimen::LabelledMask& mask);

  [[nodiscard]] int rows() const { return mask_.labels.rows; }
  [[nodiscard]] int cols() const { return mask_.labels.cols; }
  [[nodiscard]] const specimen::LabelledMask& mask() const { return mask_; }
  [[nodiscard]] const std::vector<MeshPhase>& phases() const { return phases_; }
  [[nodiscard]] std::int64_t nodes() const { return nodes_; }
  [[nodiscard]] std::int64_t elements() const;

  /// True when the node is a corner of an element.
  [[nodiscard]] bool has(MeshNode node) const;
  [[nodiscard]] std::int64_t number(MeshNode node) const {
    return std::int64_t{node.line} * (cols() + 1) + node.col + 1;
  }
  [[nodiscard]] std::int64_t element(int row, int col) const { return std::int64_t{row} * cols() + col + 1; }
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
  std::int64_t nodes_ = 0;
};

}  // namespace exchange
