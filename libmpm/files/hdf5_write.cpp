#include "libmpm/files/hdf5_write.hpp"

#include <algorithm>

#include "libmpm/solver/checkpoint.hpp"

namespace mpm::hdf5 {
namespace {

/// Chunks of at most 512 values a side, or of 16384 rows of a list or a narrow table. No time is kept, so
/// that the same values give the same bytes.
Handle dataset_settings(const std::vector<hsize_t>& extent, unsigned effort) {
  Handle settings(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(settings, false);
  if (std::find(extent.begin(), extent.end(), 0U) != extent.end()) return settings;  // no chunk can be empty
  const bool narrow = extent.size() == 1 || extent.back() <= 16;
  std::vector<hsize_t> chunk = extent;
  for (hsize_t& side : chunk) side = std::min<hsize_t>(side, narrow ? 16384 : 512);
  H5Pset_chunk(settings, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(settings);
  H5Pset_deflate(settings, effort);
  H5Pset_fletcher32(settings);
  return settings;
}

}  // namespace

void write_attribute(hid_t object, const char* name, hid_t file_type, hid_t memory_type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "out of memory");
  const Handle attribute(H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         std::string(name) + " cannot be created");
  require(H5Awrite(attribute, memory_type, value) >= 0, std::string(name) + " cannot be written");
}

void write_text(hid_t object, const char* name, const std::string& text) {
  const Handle type = text_type();
  const char* value = text.c_str();
  write_attribute(object, name, type, type, &value);
}

void write_dataset(hid_t parent, const std::string& name, const std::vector<hsize_t>& extent, hid_t file_type,
                   hid_t memory_type, const void* values, const Column& column) {
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
                     "out of memory");
  const Handle settings = dataset_settings(extent, column.effort);
  const Handle dataset(H5Dcreate2(parent, name.c_str(), file_type, space, H5P_DEFAULT, settings, H5P_DEFAULT),
                       H5Dclose, name + " cannot be created");
  require(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
          name + " cannot be written");
  write_text(dataset, "unit", column.unit);
  write_text(dataset, "meaning", column.meaning);
}

Handle create_group(hid_t parent, const char* name) {
  const Handle settings(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(settings, false);
  return {H5Gcreate2(parent, name, H5P_DEFAULT, settings, H5P_DEFAULT), H5Gclose,
          std::string(name) + " cannot be created"};
}

Handle memory_file() {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "out of memory");
  H5Pset_fapl_core(access, std::size_t{1} << 20, false);
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(creation, false);
  // HDF5 first opens what has the name, so that there must never be such a file.
  return {H5Fcreate("/dev/null/memory", H5F_ACC_TRUNC, creation, access), H5Fclose, "out of memory"};
}

std::string image_of(hid_t file) {
  require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "cannot be flushed");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  require(size > 0, "cannot be laid out");
  std::string image(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file, image.data(), image.size()) == size, "cannot be laid out");
  return image + std::string(seal_mark) + Sha256().add(image).digest();
}

}  // namespace mpm::hdf5
