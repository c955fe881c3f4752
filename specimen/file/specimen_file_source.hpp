/// Private to specimen_file_read.cpp: reading of an HDF5 file that may be damaged or malicious. Nothing is
/// read before its place, type, extent and storage are checked; every Error names the object.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "specimen/file/specimen_file_hdf5.hpp"

namespace specimen::hdf5 {

/// Whether the lengths in every global heap of a file are right. Texts of any length lie in such heaps, and
/// the sources of virtual datasets. HDF5 1.10 loops forever in a heap with wrong lengths, or reads
/// beyond its end, as soon as an attribute or a dataset that needs it is opened.
/// @return true for a file that cannot be read: opening it says why.
[[nodiscard]] bool heaps_are_sound(const std::string& path);

using Extent = std::vector<hsize_t>;

/// A dataset that has been checked but not read.
struct Dataset {
  std::string name;
  Handle id;
  Extent extent;
};

/// Open /a/b; each part must be in this file, since a link could open another file.
[[nodiscard]] Handle open_object(hid_t file, const std::string& name, H5I_type_t kind);

/// Open a dataset of that type and rank, with `limit` values at most.
[[nodiscard]] Dataset open_dataset(hid_t file, const std::string& name, hid_t type, int rank,
                                   std::int64_t limit);

/// "300 x 300".
[[nodiscard]] std::string text_of(const Extent& extent);

void read_bytes(const Dataset& dataset, hid_t memory, void* values);

template <class T>
[[nodiscard]] std::vector<T> read_values(const Dataset& dataset, hid_t memory) {
  std::size_t count = 1;
  for (const hsize_t n : dataset.extent) count *= static_cast<std::size_t>(n);
  std::vector<T> values(count);
  read_bytes(dataset, memory, values.data());
  return values;
}

template <class T>
[[nodiscard]] std::vector<T> read_list(hid_t file, const std::string& name, std::int64_t limit) {
  return read_values<T>(open_dataset(file, name, file_type<T>(), 1, limit), memory_type<T>());
}

/// List of texts of fixed length, `limit` of them at most.
[[nodiscard]] std::vector<std::string> read_texts(hid_t file, const std::string& name, std::int64_t limit);

/// Attribute of an object; `owner` is the object's name, for messages ("/rings@mode").
void read_attribute(hid_t object, const std::string& owner, const char* name, hid_t type, hid_t memory,
                    void* value);

template <class T>
[[nodiscard]] T read_attribute(hid_t object, const std::string& owner, const char* name) {
  T value{};
  read_attribute(object, owner, name, file_type<T>(), memory_type<T>(), &value);
  return value;
}

[[nodiscard]] std::string read_text_attribute(hid_t object, const std::string& owner, const char* name);

/// @throws Error when the attribute names another unit; it need not be there, nor be as mesopix writes texts.
void require_unit(hid_t object, const std::string& owner, const char* name, const std::string& unit);

/// The same of an attribute with a unit for each column, as texts of fixed length.
void require_units(const Dataset& table, const char* name, const std::vector<std::string>& units);

}  // namespace specimen::hdf5
