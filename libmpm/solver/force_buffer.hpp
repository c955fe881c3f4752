/// Forces that a row of cells exerts on its nodes, as the sweeps write and read them.
#pragma once

#include <cstddef>

#include "libmpm/kernels/aligned.hpp"
#include "libmpm/kernels/lattice_kernels.hpp"

namespace mpm {

/// Forces on one of the two rows of nodes of a row of cells, with a zero in front that belongs to no cell.
template <class Real>
class ForceBuffer {
 public:
  void resize(std::ptrdiff_t cells) {
    // A lane of zeros in front (the cell left of the first node) and behind (the cells right of the last
    // one).
    length_ = cells + 3 * kernels::lane_cells;
    values_.assign(static_cast<std::size_t>(4 * length_), Real(0));
  }
  [[nodiscard]] kernels::NodeForces<Real> forces() { return parts<Real>(values_.data()); }
  [[nodiscard]] kernels::NodeForces<const Real> forces() const { return parts<const Real>(values_.data()); }

 private:
  template <class Value>
  [[nodiscard]] kernels::NodeForces<Value> parts(Value* values) const {
    Value* first = values + kernels::lane_cells;
    // What stands at the right of node i belongs to cell i - 1: it lies one further, so that nodes read whole
    // lines.
    return {first, first + length_ + 1, first + 2 * length_, first + 3 * length_ + 1};
  }

  AlignedVector<Real> values_;
  std::ptrdiff_t length_ = 0;
};

}  // namespace mpm
