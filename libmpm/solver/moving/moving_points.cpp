#include "libmpm/solver/moving/moving_points.hpp"

#include <algorithm>

namespace mpm {

moving::RecordLayout record_layout(const moving::OptionalFields& optional) {
  moving::RecordLayout layout;
  const auto add = [&](bool wanted, int& first, int count) {
    if (!wanted) return;
    first = layout.fields;
    layout.fields += count;
  };
  add(optional.tension, layout.tension, 1);
  add(optional.crush, layout.crush, 1);
  add(optional.cracked, layout.cracked, 1);
  add(optional.affine, layout.affine, 4);
  add(optional.deformation, layout.deformation, 4);
  return layout;
}

template <class Real>
MovingPoints<Real>::MovingPoints(int rows, int cols, int lanes, moving::RecordLayout layout)
    : blocks_((cols + lanes - 1) / lanes), lanes_(lanes), layout_(layout) {
  rows_.resize(static_cast<std::size_t>(rows));
  for (Row& row : rows_)
    for (auto* counts : {&row.begin, &row.used, &row.capacity})
      counts->assign(static_cast<std::size_t>(blocks_), 0);
}

template <class Real>
std::size_t MovingPoints<Real>::place(const Slot& slot, int field) const {
  const int record = at(slot.row).begin[static_cast<std::size_t>(slot.block)] + slot.slot;
  return static_cast<std::size_t>((record * layout_.fields + field) * lanes_ + slot.lane);
}

template <class Real>
Real& MovingPoints<Real>::value(const Slot& slot, int field) {
  return rows_[static_cast<std::size_t>(slot.row)].records[place(slot, field)];
}

template <class Real>
const Real& MovingPoints<Real>::value(const Slot& slot, int field) const {
  return at(slot.row).records[place(slot, field)];
}

template <class Real>
std::uint32_t MovingPoints<Real>::id(const Slot& slot) const {
  const Row& row = at(slot.row);
  const int record = row.begin[static_cast<std::size_t>(slot.block)] + slot.slot;
  return row.ids[static_cast<std::size_t>(record * lanes_ + slot.lane)];
}

template <class Real>
std::uint32_t& MovingPoints<Real>::id_at(const Slot& slot) {
  Row& row = rows_[static_cast<std::size_t>(slot.row)];
  const int record = row.begin[static_cast<std::size_t>(slot.block)] + slot.slot;
  return row.ids[static_cast<std::size_t>(record * lanes_ + slot.lane)];
}

template <class Real>
void MovingPoints<Real>::clear_lane(const Slot& slot) {
  for (int field = 0; field < layout_.fields; ++field) value(slot, field) = 0;
  value(slot, moving::xi) = value(slot, moving::eta) = Real(0.5);
  for (const int threshold : {layout_.tension, layout_.crush})
    if (threshold >= 0) value(slot, threshold) = static_cast<Real>(kernels::unreachable);
  id_at(slot) = 0;
}

/// Every block gets room for one record more than it has, and every third of what it has.
template <class Real>
void MovingPoints<Real>::grow(Row& row) {
  Row grown = row;
  std::int32_t records = 0;
  for (std::size_t block = 0; block < row.begin.size(); ++block) {
    grown.begin[block] = records;
    grown.capacity[block] = row.used[block] + 1 + row.used[block] / 3;
    records += grown.capacity[block];
  }
  const auto record_size = static_cast<std::size_t>(layout_.fields * lanes_);
  const auto lanes = static_cast<std::size_t>(lanes_);
  grown.records.assign(static_cast<std::size_t>(records) * record_size, Real(0));
  grown.ids.assign(static_cast<std::size_t>(records) * lanes, 0);
  for (std::size_t block = 0; block < row.begin.size(); ++block) {
    const auto from = static_cast<std::size_t>(row.begin[block]);
    const auto to = static_cast<std::size_t>(grown.begin[block]);
    const auto count = static_cast<std::size_t>(row.used[block]);
    std::copy_n(row.records.begin() + static_cast<std::ptrdiff_t>(from * record_size), count * record_size,
                grown.records.begin() + static_cast<std::ptrdiff_t>(to * record_size));
    std::copy_n(row.ids.begin() + static_cast<std::ptrdiff_t>(from * lanes), count * lanes,
                grown.ids.begin() + static_cast<std::ptrdiff_t>(to * lanes));
  }
  row = std::move(grown);
}

/// A block that is wanted gets one record more: for the first point that comes from beside it.
template <class Real>
void MovingPoints<Real>::reserve(int row_index, const std::vector<std::int32_t>& records) {
  Row& row = rows_[static_cast<std::size_t>(row_index)];
  std::int32_t all = 0;
  for (std::size_t block = 0; block < records.size(); ++block) {
    row.begin[block] = all;
    row.capacity[block] = records[block] > 0 ? records[block] + 1 : 0;
    all += row.capacity[block];
  }
  row.records.assign(static_cast<std::size_t>(all) * static_cast<std::size_t>(layout_.fields * lanes_),
                     Real(0));
  row.ids.assign(static_cast<std::size_t>(all) * static_cast<std::size_t>(lanes_), 0);
}

template <class Real>
void MovingPoints<Real>::add_record(int row_index, int block) {
  Row& row = rows_[static_cast<std::size_t>(row_index)];
  const auto b = static_cast<std::size_t>(block);
  if (row.used[b] == row.capacity[b]) grow(row);
  const int slot = row.used[b]++;
  for (int lane = 0; lane < lanes_; ++lane) clear_lane({row_index, block, slot, lane});
}

template <class Real>
void MovingPoints<Real>::insert(const Loose& point) {
  Slot slot{point.tile.row, point.tile.col / lanes_, 0, point.tile.col % lanes_};
  while (slot.slot < used(slot.row, slot.block) && is_point(slot)) ++slot.slot;
  if (slot.slot == used(slot.row, slot.block)) add_record(slot.row, slot.block);
  for (int field = 0; field < layout_.fields; ++field)
    value(slot, field) = point.values[static_cast<std::size_t>(field)];
  id_at(slot) = point.id;
  ++rows_[static_cast<std::size_t>(slot.row)].points;
}

template <class Real>
typename MovingPoints<Real>::Loose MovingPoints<Real>::take_out(const Slot& slot) {
  Loose point;
  point.tile = {slot.row, slot.block * lanes_ + slot.lane};
  point.id = id(slot);
  for (int field = 0; field < layout_.fields; ++field)
    point.values[static_cast<std::size_t>(field)] = value(slot, field);
  clear_lane(slot);
  Row& row = rows_[static_cast<std::size_t>(slot.row)];
  --row.points;
  return point;
}

template <class Real>
void MovingPoints<Real>::trim(int row_index, int block) {
  std::int32_t& used = rows_[static_cast<std::size_t>(row_index)].used[static_cast<std::size_t>(block)];
  const auto is_empty = [&](int slot) {
    for (int lane = 0; lane < lanes_; ++lane)
      if (is_point({row_index, block, slot, lane})) return false;
    return true;
  };
  while (used > 0 && is_empty(used - 1)) --used;
}

template <class Real>
moving::TileRow<Real> MovingPoints<Real>::tile_row(int index, Real bottom) {
  Row& row = rows_[static_cast<std::size_t>(index)];
  return {row.records.data(), row.begin.data(), row.used.data(), blocks_, layout_, bottom};
}

template class MovingPoints<float>;
template class MovingPoints<double>;

}  // namespace mpm
