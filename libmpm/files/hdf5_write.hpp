/// Writing of HDF5 datasets, attributes and files. Not installed: private to result_file*, frame_file*,
/// table_file*.
#pragma once

#include <string>
#include <vector>

#include "libmpm/files/hdf5_handle.hpp"

namespace mpm::hdf5 {

/// An attribute of one value, of an object.
void write_attribute(hid_t object, const char* name, hid_t file_type, hid_t memory_type, const void* value);

template <class T>
void write_number(hid_t object, const char* name, T value) {
  write_attribute(object, name, Number<T>::file(), Number<T>::memory(), &value);
}

void write_text(hid_t object, const char* name, const std::string& text);

/// What a dataset holds, for its attributes `unit` and `meaning`, and how it is kept.
struct Column {
  std::string unit;
  std::string meaning;
  unsigned effort = 6;  ///< of the compression, 1 = fast ... 9 = small
};

/// A dataset in chunks, compressed and with a checksum.
/// @param extent  lengths of the axes.   @param values  as many as their product, row by row.   @throws
/// Fault.
void write_dataset(hid_t parent, const std::string& name, const std::vector<hsize_t>& extent, hid_t file_type,
                   hid_t memory_type, const void* values, const Column& column);

template <class T>
void write_values(hid_t parent, const std::string& name, const std::vector<hsize_t>& extent, const T* values,
                  const Column& column) {
  write_dataset(parent, name, extent, Number<T>::file(), Number<T>::memory(), values, column);
}

[[nodiscard]] Handle create_group(hid_t parent, const char* name);

/// A file in memory: then a full disk affects only one plain write, not HDF5.
[[nodiscard]] Handle memory_file();
/// Its bytes, and behind them a seal: a digest of them, which readers check and other programs pass over.
[[nodiscard]] std::string image_of(hid_t file);

}  // namespace mpm::hdf5
