/// Moving points, sorted by tile, in the layout of the sweeps.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libmpm/kernels/aligned.hpp"
#include "libmpm/kernels/moving_kernels.hpp"
#include "libmpm/solver/archive.hpp"

namespace mpm {

[[nodiscard]] moving::RecordLayout record_layout(const moving::OptionalFields& optional);

/// Place of a point among the tiles.
struct TilePlace {
  int row = 0, col = 0;
  friend bool operator==(const TilePlace&, const TilePlace&) = default;
};

/// Points of all tiles, row by row. A row is cut into blocks of `lanes` tiles; the points of a block fill its
/// records lane by lane, the lane of a point being its tile.
template <class Real>
class MovingPoints {
 public:
  static constexpr int max_fields = 24;
  /// A point outside of the storage, its fields in the order of a record.
  struct Loose {
    TilePlace tile;
    std::uint32_t id = 0;
    std::array<Real, max_fields> values{};
  };

  /// Where a point lies in the storage.
  struct Slot {
    int row = 0, block = 0, slot = 0, lane = 0;
  };

  MovingPoints() = default;
  MovingPoints(int rows, int cols, int lanes, moving::RecordLayout layout);

  [[nodiscard]] int rows() const { return static_cast<int>(rows_.size()); }
  [[nodiscard]] int blocks() const { return blocks_; }
  [[nodiscard]] int lanes() const { return lanes_; }
  [[nodiscard]] const moving::RecordLayout& layout() const { return layout_; }
  [[nodiscard]] int used(int row, int block) const { return at(row).used[static_cast<std::size_t>(block)]; }
  [[nodiscard]] bool is_empty(int row) const { return at(row).points == 0; }
  [[nodiscard]] std::int64_t points(int row) const { return at(row).points; }

  /// Fields of a point; a point without mass is an empty lane.
  [[nodiscard]] Real& value(const Slot& slot, int field);
  [[nodiscard]] const Real& value(const Slot& slot, int field) const;
  [[nodiscard]] std::uint32_t id(const Slot& slot) const;
  [[nodiscard]] bool is_point(const Slot& slot) const { return value(slot, moving::mass) > 0; }

  /// Room in a row that holds no points yet.   @param records  wanted of each block, shape (blocks).
  void reserve(int row, const std::vector<std::int32_t>& records);
  void insert(const Loose& point);
  /// The lane stays empty until `trim`.
  [[nodiscard]] Loose take_out(const Slot& slot);
  /// Gives up the last records of a block when they are empty.
  void trim(int row, int block);

  /// As the sweeps want it. `bottom`: lower edge of the row over the height of a cell.
  [[nodiscard]] moving::TileRow<Real> tile_row(int row, Real bottom);

  void save(ArchiveWriter& archive) const;
  /// Into a storage of the same rows, columns, lanes and layout that holds no points yet; `count_points` is
  /// to follow.
  void restore(ArchiveReader& archive);
  void count_points();

  /// Calls visit(Slot) for every point of a row, in the order of the storage.
  template <class Visit>
  void for_each(int row, Visit&& visit) const {
    for (int block = 0; block < blocks_; ++block) for_each_of_block(row, block, visit);
  }
  template <class Visit>
  void for_each_of_block(int row, int block, Visit&& visit) const {
    for (int slot = 0; slot < used(row, block); ++slot)
      for (int lane = 0; lane < lanes_; ++lane)
        if (const Slot place{row, block, slot, lane}; is_point(place)) visit(place);
  }

 private:
  struct Row {
    std::vector<std::int32_t> begin, used, capacity;  ///< records, shape (blocks)
    AlignedVector<Real> records;
    std::vector<std::uint32_t> ids;
    std::int64_t points = 0;
  };

  [[nodiscard]] const Row& at(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] std::size_t place(const Slot& slot, int field) const;
  [[nodiscard]] std::uint32_t& id_at(const Slot& slot);
  void clear_lane(const Slot& slot);
  void add_record(int row, int block);
  void grow(Row& row);
  void restore_row(Row& row, ArchiveReader& archive);

  int blocks_ = 0;
  int lanes_ = 0;
  moving::RecordLayout layout_;
  std::vector<Row> rows_;
};

}  // namespace mpm
