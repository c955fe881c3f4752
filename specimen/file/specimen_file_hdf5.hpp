/// Private to specimen_file*.cpp: HDF5 handles that close automatically, and the common layout.
///
///   /                 attributes format, format_version, pixel_size, pixel_size_unit
///   /labels           uint8, shape (rows, cols); attribute orientation
///   /phases           strings; phases[label] is the name of the label
///   /inclusions       table of InclusionRow; attribute units, one per column
///   /contours         offsets, points: contour k is points[offsets[k]] ... points[offsets[k + 1] - 1]
///   /rings            offsets, points, inclusion (id); attributes mode, thickness, thickness_unit, segments
///   /provenance       options (one string); attributes source, sha256, seed, version
#pragma once

#include <hdf5.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "specimen/body/error.hpp"

namespace specimen::hdf5 {

inline constexpr const char* format_name = "mesopix specimen";
inline constexpr int format_version = 1;

/// Names of the ITZ modes, in the order of ItzMode.
inline constexpr std::array<const char*, 3> itz_modes = {"ring", "points", "none"};

/// Turns off the printing of HDF5 during its lifetime; then the setting of the caller is restored, unless
/// it is told to stay off.
class Quiet {
 public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }

  /// HDF5 1.10 loses track of memory when a checksum fails, and complains of it on the terminal when the
  /// program ends, if printing is on then.
  void stay() { print_ = nullptr; }

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// The innermost entry of the HDF5 error stack: the actual fault.
inline std::string reason() {
  const auto first = [](unsigned n, const H5E_error2_t* entry, void* text) -> herr_t {
    if (n == 0 && entry->desc != nullptr) *static_cast<std::string*>(text) = entry->desc;
    return 0;
  };
  std::string text = "HDF5 gives no reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, first, &text);
  return text;
}

/// Whether the last call failed for want of memory.
inline bool lacks_memory() {
  const auto look = [](unsigned, const H5E_error2_t* entry, void* found) -> herr_t {
    if (entry->min_num == H5E_NOSPACE || entry->min_num == H5E_CANTALLOC) *static_cast<bool*>(found) = true;
    return 0;
  };
  bool found = false;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, look, &found);
  return found;
}

/// @throws Error about `object` with the reason of HDF5 if a call failed, std::bad_alloc for want of memory.
template <class Result>
Result require(Result result, const std::string& object) {
  if (result < 0 && lacks_memory()) throw std::bad_alloc();
  if (result < 0)
    throw Error(object, reason(), {},
                "the file is damaged or cut short: take a copy of it, or make the specimen again");
  return result;
}

/// Owner of one HDF5 identifier, of whatever kind.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, const std::string& object) : id_(require(id, object)) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    // cppcheck-suppress accessMoved ; the temporary that took it is swapped with, and closes what this held
    Handle(std::move(other)).swap(*this);
    return *this;
  }
  ~Handle() {
    if (id_ >= 0) H5Idec_ref(id_);
  }
  operator hid_t() const { return id_; }  // NOLINT: stands for the identifier in every call of the C library

 private:
  void swap(Handle& other) noexcept { std::swap(id_, other.id_); }

  hid_t id_ = -1;
};

/// Type in the file (little-endian, the same on every machine) and in memory.
template <class T>
hid_t file_type();
template <>
inline hid_t file_type<std::uint8_t>() {
  return H5T_STD_U8LE;
}
template <>
inline hid_t file_type<std::int32_t>() {
  return H5T_STD_I32LE;
}
template <>
inline hid_t file_type<std::int64_t>() {
  return H5T_STD_I64LE;
}
template <>
inline hid_t file_type<std::uint64_t>() {
  return H5T_STD_U64LE;
}
template <>
inline hid_t file_type<double>() {
  return H5T_IEEE_F64LE;
}

template <class T>
hid_t memory_type();
template <>
inline hid_t memory_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}
template <>
inline hid_t memory_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
inline hid_t memory_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
inline hid_t memory_type<std::uint64_t>() {
  return H5T_NATIVE_UINT64;
}
template <>
inline hid_t memory_type<double>() {
  return H5T_NATIVE_DOUBLE;
}

/// Fixed-length UTF-8, padded with zeros: unlike HDF5's variable length its size is known before it is read.
inline Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), "text");
  H5Tset_size(type, length > 0 ? length : 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  return type;
}

/// A row of /inclusions.
struct InclusionRow {
  std::int32_t id;
  double x, y, a, b, angle, area, perimeter, equivalent_diameter, orientation;
};

/// A column of doubles.
struct Column {
  const char* name;
  const char* unit;
  std::size_t offset;
};

inline constexpr std::array<Column, 9> inclusion_columns = {{
    {"x", "m", offsetof(InclusionRow, x)},
    {"y", "m", offsetof(InclusionRow, y)},
    {"a", "m", offsetof(InclusionRow, a)},
    {"b", "m", offsetof(InclusionRow, b)},
    {"angle", "rad", offsetof(InclusionRow, angle)},
    {"area", "m^2", offsetof(InclusionRow, area)},
    {"perimeter", "m", offsetof(InclusionRow, perimeter)},
    {"equivalent_diameter", "m", offsetof(InclusionRow, equivalent_diameter)},
    {"orientation", "rad", offsetof(InclusionRow, orientation)},
}};

inline std::vector<std::string> inclusion_units() {
  std::vector<std::string> units = {"-"};  // of the id
  for (const Column& column : inclusion_columns) units.emplace_back(column.unit);
  return units;
}

/// Table type, laid out as InclusionRow in memory; packed, without the padding, in the file.
inline Handle inclusion_type(bool in_file) {
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(InclusionRow)), "/inclusions");
  H5Tinsert(type, "id", offsetof(InclusionRow, id),
            in_file ? file_type<std::int32_t>() : memory_type<std::int32_t>());
  for (const Column& column : inclusion_columns)
    H5Tinsert(type, column.name, column.offset, in_file ? file_type<double>() : memory_type<double>());
  if (in_file) H5Tpack(type);
  return type;
}

}  // namespace specimen::hdf5
