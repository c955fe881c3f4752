#include "libmpm/result_file.hpp"

#include <algorithm>

#include "libmpm/error.hpp"
#include "libmpm/history_columns.hpp"
#include "libmpm/replace_file.hpp"
#include "libmpm/result_file_hdf5.hpp"

namespace mpm {
namespace {

using namespace result_file;

void write_attribute(hid_t object, const char* name, hid_t file_type, hid_t memory_type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "out of memory");
  const Handle attribute(H5Acreate2(object, name, file_type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         std::string(name) + " cannot be created");
  require(H5Awrite(attribute, memory_type, value) >= 0, std::string(name) + " cannot be written");
}

template <class T>
void write_number(hid_t object, const char* name, T value) {
  write_attribute(object, name, Number<T>::file(), Number<T>::memory(), &value);
}

void write_text(hid_t object, const char* name, const std::string& text) {
  const Handle type = text_type();
  const char* value = text.c_str();
  write_attribute(object, name, type, type, &value);
}

/// Chunks of at most 512 values a side, compressed and with a checksum. No time is kept, so that the same
/// result gives the same bytes.
Handle dataset_settings(const std::vector<hsize_t>& extent) {
  Handle settings(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(settings, false);
  if (std::find(extent.begin(), extent.end(), 0U) != extent.end()) return settings;  // no chunk can be empty
  std::vector<hsize_t> chunk = extent;
  for (hsize_t& side : chunk) side = std::min<hsize_t>(side, extent.size() == 1 ? 16384 : 512);
  H5Pset_chunk(settings, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(settings);
  H5Pset_deflate(settings, 6);
  H5Pset_fletcher32(settings);
  return settings;
}

template <class T>
void write_values(hid_t parent, const std::string& name, const std::vector<hsize_t>& extent, const T* values,
                  const std::string& unit, const std::string& meaning) {
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
                     "out of memory");
  const Handle settings = dataset_settings(extent);
  const Handle dataset(
      H5Dcreate2(parent, name.c_str(), Number<T>::file(), space, H5P_DEFAULT, settings, H5P_DEFAULT),
      H5Dclose, name + " cannot be created");
  require(H5Dwrite(dataset, Number<T>::memory(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
          name + " cannot be written");
  write_text(dataset, "unit", unit);
  write_text(dataset, "meaning", meaning);
}

template <class T>
void write_map(hid_t parent, const std::string& name, const Lattice<T>& map, const std::string& meaning,
               const std::string& unit = "1") {
  write_values(parent, name, {static_cast<hsize_t>(map.rows()), static_cast<hsize_t>(map.cols())}, map.data(),
               unit, meaning);
}

template <class T>
void write_column(hid_t group, const HistoryColumn& column, T HistoryRow::*member,
                  const std::vector<HistoryRow>& history) {
  std::vector<T> values(history.size());
  std::transform(history.begin(), history.end(), values.begin(),
                 [&](const HistoryRow& row) { return row.*member; });
  write_values(group, std::string(column.name), {values.size()}, values.data(), std::string(column.unit),
               std::string(column.meaning));
}

void write_history(hid_t file, const std::vector<HistoryRow>& history) {
  const Handle settings(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(settings, false);
  const Handle group(H5Gcreate2(file, "history", H5P_DEFAULT, settings, H5P_DEFAULT), H5Gclose,
                     "history cannot be created");
  for (const HistoryColumn& column : history_columns())
    std::visit([&](auto member) { write_column(group, column, member, history); }, column.member);
}

std::string stop_name(StopReason reason) {
  for (const auto& [value, name] : stop_reasons)
    if (value == reason) return name;
  throw Fault("stop_reason has no name");
}

void write_figures(hid_t file, const Result& result, const std::string& scene_text) {
  write_text(file, "format", format_name);
  write_number(file, "format_version", format_version);
  write_number(file, "peak_stress_Pa", result.peak_stress);
  write_number(file, "peak_strain", result.peak_strain);
  write_number(file, "tension_failures", result.tension_failures);
  write_number(file, "shear_failures", result.shear_failures);
  write_number(file, "points", result.points);
  write_number(file, "steps", result.steps);
  write_number(file, "dt_s", result.dt);
  write_number(file, "wall_time_s", result.wall_time);
  write_number(file, "energy_error", result.energy_error);
  write_text(file, "instruction_set", result.instruction_set);
  write_number(file, "threads", result.threads);
  write_text(file, "stop_reason", stop_name(result.stop));
  write_number(file, "nothing_carries", std::int64_t{result.nothing_carries});
  write_text(file, "scene", scene_text);
}

void write_maps(hid_t file, const Result& result) {
  write_map(file, "failure_strain", result.failure_strain,
            "platen strain at which the point of a pixel failed, NaN = it did not; row 0 is the top");
  write_map(file, "failure_mode", result.failure_mode, "0 = none, 1 = tension, 2 = shear; row 0 is the top");
  if (result.crush_strain.size() > 0)
    write_map(
        file, "crush_strain", result.crush_strain,
        "platen strain at which a cracked point was crushed in shear, NaN = it was not; row 0 is the top");
  if (result.end_x.size() > 0) {
    write_map(file, "end_x", result.end_x,
              "place of the point of a pixel at the end, NaN = none; row 0 is the top", "m");
    write_map(file, "end_y", result.end_y, "the same, upwards from the lower edge of the picture", "m");
  }
  for (std::size_t i = 0; i < result.deformation.size(); ++i)
    if (result.deformation[i].size() > 0)
      write_map(file, deformation_names[i], result.deformation[i],
                "deformation gradient of the point of a pixel at the end; row 0 is the top");
}

/// A file that lives in memory: a full disk can then hit one plain write only, not HDF5 on its way out.
Handle memory_file() {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "out of memory");
  H5Pset_fapl_core(access, std::size_t{1} << 20, false);
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "out of memory");
  H5Pset_obj_track_times(creation, false);
  return {H5Fcreate("result", H5F_ACC_TRUNC, creation, access), H5Fclose, "out of memory"};
}

std::string image_of(hid_t file) {
  require(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, "cannot be flushed");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  require(size > 0, "cannot be laid out");
  std::string image(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file, image.data(), image.size()) == size, "cannot be laid out");
  return image;
}

}  // namespace

void write_result(const std::string& path, const Result& result, const std::string& scene_text) try {
  const Quiet quiet;
  const Handle file = memory_file();
  write_figures(file, result, scene_text);
  write_history(file, result.history);
  write_maps(file, result);
  replace_file(path, image_of(file));
} catch (const Fault& fault) {
  throw FileError(path, fault.what(), "");
}

}  // namespace mpm
