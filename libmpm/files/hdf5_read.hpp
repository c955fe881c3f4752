/// Reading of HDF5 files, attributes and datasets. Not installed: private to result_file*, frame_file*.
///
/// Every claim of a file is checked: values have the required type and axes, are stored in the file itself,
/// and are complete.
#pragma once

#include <string>
#include <vector>

#include "libmpm/files/hdf5_handle.hpp"

namespace mpm::hdf5 {

/// Whether the lengths in every global heap of a file are right. Texts of any length lie in such heaps, and
/// the sources of virtual datasets. HDF5 1.10 loops forever in a heap with wrong lengths, or reads
/// beyond its end, as soon as an attribute or a dataset that needs it is opened.
/// @return true for a file that cannot be read: opening it says why.
[[nodiscard]] bool heaps_are_sound(const std::string& path);

/// Whether the seal of a file fits its bytes: bits that were flipped in the bookkeeping of HDF5 can empty a
/// dataset without a word.   @return true for a file that has none, of another program or changed by one.
[[nodiscard]] bool seal_fits(const std::string& path);

/// @throws Fault if it is not a file, not an HDF5 file, or one on which HDF5 would fail.
[[nodiscard]] Handle open_file(const std::string& path);

/// A part of a group, by its own name.   @throws Fault when it is missing or a link to somewhere else.
[[nodiscard]] Handle open_group(hid_t parent, const std::string& name);

/// An attribute of `count` numbers, of an object.   @throws Fault.
void read_attribute(hid_t object, const char* name, H5T_class_t kind, std::size_t size, hid_t memory_type,
                    void* values, int count = 1);

template <class T>
[[nodiscard]] T read_number(hid_t object, const char* name) {
  T value{};
  read_attribute(object, name, Number<T>::kind, sizeof(T), Number<T>::memory(), &value);
  return value;
}

/// An attribute of one text of any length.   @throws Fault.
[[nodiscard]] std::string read_text(hid_t object, const char* name);

/// A dataset that has been checked.
struct Dataset {
  std::string words;  ///< "dataset stress"
  Handle id;
  std::vector<hsize_t> extent;  ///< lengths of its axes; its data fill them
};

/// @throws Fault when it is missing, a link, of another type or number of axes, or when its data are not all
/// in the file.
[[nodiscard]] Dataset open_dataset(hid_t parent, const std::string& name, std::size_t rank, H5T_class_t kind,
                                   std::size_t size);

/// All of it, row by row.   @throws Fault when its checksum or its packing is wrong.
void read_all(const Dataset& dataset, hid_t memory_type, void* values);

/// @throws Fault when the dataset names another unit; it need not name any.
void require_unit(const Dataset& dataset, const std::string& unit);

/// @param unit  as it is written; "1" = dimensionless.   @param allocate  given the extent, returns where to
/// put the values.
template <class T, class Allocate>
void read_values(hid_t parent, const std::string& name, std::size_t rank, const std::string& unit,
                 Allocate allocate) {
  const Dataset dataset = open_dataset(parent, name, rank, Number<T>::kind, sizeof(T));
  require_unit(dataset, unit);
  T* values = allocate(dataset.extent);
  read_all(dataset, Number<T>::memory(), values);
}

}  // namespace mpm::hdf5
